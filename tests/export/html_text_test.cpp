#include "export/html_text.h"

#include <doctest/doctest.h>

namespace html_text_test {

using namespace multipath;

TEST_CASE("text in HTML can neither open a tag nor end an attribute")
{
    CHECK(html_escaped("a < b > \"c\" & d &amp; 'e'") == "a &lt; b &gt; &quot;c&quot; &amp; d &amp;amp; 'e'");
}

TEST_CASE("escaped text is read back as it was, entities that it held included")
{
    for (const char* text : {"", "a < b > \"c\" & d &amp; 'e'", "&lt;", "&", "&amp"})
        CHECK(html_unescaped(html_escaped(text)) == text);
    CHECK(html_unescaped("&unknown; &") == "&unknown; &");
}

TEST_CASE("a part of a page's record stands between the marks by which it is found, and cannot end early")
{
    const std::string line = html_record_line("command: multipath solve '\">.obj'");
    const std::size_t end = line.find(html_record_end);
    REQUIRE(line.find(html_record_begin) == 0);
    CHECK(end + html_record_end.size() + 1 == line.size());
    CHECK(html_unescaped(line.substr(html_record_begin.size(), end - html_record_begin.size())) ==
          "command: multipath solve '\">.obj'");
}

TEST_CASE("what is between two marks is replaced with them, as often as both are there")
{
    const auto bold = [](const std::string& between) { return "<" + between + ">"; };
    CHECK(replaced_between("a *b* c **d*", "*", "*", bold) == "a <b> c <>d*");
    CHECK(replaced_between("{{a}} }}{{b", "{{", "}}", bold) == "<a> }}{{b");
    CHECK(replaced_between("", "*", "*", bold).empty());
}

} // namespace html_text_test
