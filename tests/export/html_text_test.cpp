#include "export/html_text.h"

#include <doctest/doctest.h>

#include <string>

namespace html_text_test {

using namespace multipath;

TEST_CASE("text in HTML can neither open a tag nor end an attribute")
{
    CHECK(html_escaped("a < b > \"c\" & d &amp; 'e'") == "a &lt; b &gt; &quot;c&quot; &amp; d &amp;amp; 'e'");
}

TEST_CASE("bytes that are not UTF-8 are taken for Latin-1")
{
    CHECK(html_escaped("caf\xe9") == "caf\xc3\xa9");
    CHECK(html_escaped("caf\xc3\xa9") == "caf\xc3\xa9");
}

TEST_CASE("a part of a page's record is one line, whose attribute the text cannot end")
{
    CHECK(html_record_line("command: multipath solve '\">.obj'") ==
          "<meta name=\"multipath\" content=\"command: multipath solve '&quot;&gt;.obj'\">\n");
}

// The test vectors of RFC 4648, section 10.
TEST_CASE("base64 is that of RFC 4648")
{
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foob") == "Zm9vYg==");
    CHECK(base64("fooba") == "Zm9vYmE=");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64(std::string("\xff\xfe\x00", 3)) == "//4A");
}

} // namespace html_text_test
