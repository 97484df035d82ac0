#include "export/html_text.h"

#include <doctest/doctest.h>

namespace html_text_test {

using namespace multipath;

TEST_CASE("text in HTML can neither open a tag nor end an attribute")
{
    CHECK(html_escaped("a < b > \"c\" & d &amp; 'e'") == "a &lt; b &gt; &quot;c&quot; &amp; d &amp;amp; 'e'");
}

TEST_CASE("a part of a page's record is one line, whose attribute the text cannot end")
{
    CHECK(html_record_line("command: multipath solve '\">.obj'") ==
          "<meta name=\"multipath\" content=\"command: multipath solve '&quot;&gt;.obj'\">\n");
}

TEST_CASE("what is between two marks is replaced with them, as often as both are there")
{
    const auto bold = [](const std::string& between) { return "<" + between + ">"; };
    CHECK(replaced_between("a *b* c **d*", "*", "*", bold) == "a <b> c <>d*");
    CHECK(replaced_between("{{a}} }}{{b", "{{", "}}", bold) == "<a> }}{{b");
    CHECK(replaced_between("", "*", "*", bold).empty());
}

} // namespace html_text_test
