#include "base/text_format.h"

#include <doctest/doctest.h>
#include <string>

namespace text_format_test {

using namespace multipath;

TEST_CASE("a formatted text may have any length")
{
    CHECK(format("%s", "").empty());
    for (const std::size_t length : {1u, 510u, 511u, 512u, 513u, 100000u}) {
        const std::string name(length, 'x');
        CHECK(format("<%s> %d\n", name.c_str(), 7) == "<" + name + "> 7\n");
    }
}

TEST_CASE("large counts are written in groups of three digits")
{
    CHECK(grouped(0) == "0");
    CHECK(grouped(999) == "999");
    CHECK(grouped(1000) == "1,000");
    CHECK(grouped(4194304) == "4,194,304");
}

namespace {

/// By the bits of a character's number, as RFC 3629 lays them out in so many bytes, needed or not.
std::string laid_out(unsigned number, int size)
{
    if (size == 1)
        return std::string(1, static_cast<char>(number));
    std::string bytes;
    for (int k = size - 1; k >= 0; --k)
        bytes += static_cast<char>(0x80u | (number >> 6 * k & 0x3fu));
    const unsigned marks[] = {0xc0u, 0xe0u, 0xf0u};
    bytes[0] = static_cast<char>(marks[size - 2] | number >> 6 * (size - 1));
    return bytes;
}

} // namespace

TEST_CASE("every character is well-formed in as many bytes as it needs, and in no more")
{
    for (unsigned number = 0; number < 0x118000u; number += number < 0x3000u ? 1 : 97) {
        const int needed = number < 0x80u ? 1 : number < 0x800u ? 2 : number < 0x10000u ? 3 : 4;
        const bool exists = number < 0x110000u && !(number >= 0xd800u && number < 0xe000u);
        CAPTURE(number);
        for (int size = needed; size <= 4; ++size) {
            const std::string bytes = laid_out(number, size) + "x";
            const bool good = size == needed && exists;
            CHECK(utf8_character_size(bytes) == (good ? static_cast<std::size_t>(size) : 0u));
            CHECK(utf8_character_size(bytes.substr(0, static_cast<std::size_t>(size) - 1)) == 0);
        }
    }
    CHECK(utf8_character_size("\x80") == 0);
    CHECK(utf8_character_size("\xff\xbf\xbf\xbf") == 0);
}

TEST_CASE("a character takes one column, of however many bytes it is")
{
    CHECK(column_count("") == 0);
    CHECK(column_count("plain") == 5);
    CHECK(column_count("caf\xc3\xa9, 3 \xe2\x82\xac, \xf0\x9f\x92\xa1") == 12);
}

} // namespace text_format_test
