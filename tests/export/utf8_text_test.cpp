#include "export/utf8_text.h"

#include <doctest/doctest.h>

namespace utf8_text_test {

using namespace multipath;

TEST_CASE("what is UTF-8 stays as it is")
{
    for (const char* text :
         {"", "plain", "caf\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x92\xa1", "\xf4\x8f\xbf\xbf", "\x7f"})
        CHECK(utf8_text(text) == text);
}

// RFC 3629, sections 3 and 10: bytes alone, sequences cut short, longer than needed, halves of pairs, beyond U+10FFFF.
TEST_CASE("other bytes become the Latin-1 characters of their values")
{
    CHECK(utf8_text("caf\xe9 au lait") == "caf\xc3\xa9 au lait");
    CHECK(utf8_text("\x80") == "\xc2\x80");
    CHECK(utf8_text("\xc3") == "\xc3\x83");
    CHECK(utf8_text("\xc3 ") == "\xc3\x83 ");
    CHECK(utf8_text("\xc0\xaf") == "\xc3\x80\xc2\xaf");
    CHECK(utf8_text("\xe0\x9f\xbf") == "\xc3\xa0\xc2\x9f\xc2\xbf");
    CHECK(utf8_text("\xed\xa0\x80") == "\xc3\xad\xc2\xa0\xc2\x80");
    CHECK(utf8_text("\xf4\x90\x80\x80") == "\xc3\xb4\xc2\x90\xc2\x80\xc2\x80");
    CHECK(utf8_text("\xff") == "\xc3\xbf");
}

} // namespace utf8_text_test
