#include "export/html_text.h"

#include <doctest/doctest.h>

using namespace multipath;

TEST_CASE("text in HTML can neither open a tag nor end an attribute")
{
    CHECK(html_escaped("a < b > \"c\" & d &amp; 'e'") == "a &lt; b &gt; &quot;c&quot; &amp; d &amp;amp; 'e'");
}
