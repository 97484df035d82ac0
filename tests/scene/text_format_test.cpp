#include "scene/text_format.h"

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

} // namespace text_format_test
