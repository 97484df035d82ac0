#include "scene/text/text_words.h"

#include "scene/input_problem.h"

#include <doctest/doctest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace text_words_test {

using namespace multipath;

// The C library rounds correctly, so the results must be the same bits.
TEST_CASE("a number is the double nearest to its digits")
{
    std::mt19937_64 random(1);
    const auto digits = [&](std::size_t count) {
        std::string text;
        for (std::size_t i = 0; i < count; ++i)
            text += static_cast<char>('0' + random() % 10);
        return text;
    };
    const std::array<const char*, 3> signs = {"", "-", "+"};
    for (int i = 0; i < 20000; ++i) {
        std::string text = signs[random() % 3] + digits(1 + random() % 12);
        if (random() % 2 == 0)
            text += "." + digits(random() % 20);
        if (random() % 2 == 0)
            text += (random() % 2 == 0 ? "e" : "E") + std::string(signs[random() % 3]) + digits(1 + random() % 2);
        CAPTURE(text);
        const std::optional<double> value = to_number(text);
        REQUIRE(value.has_value());
        CHECK(*value == std::strtod(text.c_str(), nullptr));
    }
}

TEST_CASE("long, small and odd numbers are read too")
{
    CHECK(to_number("-.5") == -0.5);
    CHECK(to_number("+1.") == 1.0);
    CHECK(to_number("1E+0") == 1.0);
    CHECK(to_number("0e99999999999999999999") == 0.0);
    CHECK(to_number("1e-400") == 0.0);
    CHECK(to_number(std::string(1000, '1') + "e-999") == to_number("1." + std::string(999, '1')));
    CHECK(to_number("0." + std::string(400, '0') + "1e401") == 1.0);
    CHECK(to_number("179769313486231570000e288") == 1.7976931348623157e308);
}

TEST_CASE("what is not a finite decimal number is no number")
{
    for (const char* text : {"", "-", ".", "e5", "1e", "1e+", "1.2.3", "1x", "0x10", "1,5", "nan", "-nan", "inf",
                             "Infinity", "1e400", "--1", "1d5", "1 2"}) {
        CAPTURE(text);
        CHECK_FALSE(to_number(text).has_value());
    }
}

TEST_CASE("the message about a bad number says what it is instead")
{
    const auto problem = [](const char* word) { return problem_of([&] { read_number(word, {"a.mtl", 7}, "Kd"); }); };
    CHECK(problem("") == "a.mtl:7: Kd: a number is missing");
    CHECK(problem("-Inf") == "a.mtl:7: Kd: `-Inf` is not a finite number");
    CHECK(problem("1e400") == "a.mtl:7: Kd: `1e400` is not a finite number");
    CHECK(problem("-1.#IND") == "a.mtl:7: Kd: `-1.#IND` is not a finite number");
    CHECK(problem("1.#INF00") == "a.mtl:7: Kd: `1.#INF00` is not a finite number");
    CHECK(problem("1,5") == "a.mtl:7: Kd: `1,5` is not a finite number, expected a decimal point");
    CHECK(problem("1x") == "a.mtl:7: Kd: `1x` is not a finite number");
}

TEST_CASE("a number sign ends the numbers of a statement, but not within a number that is not finite")
{
    CHECK(without_comment(" 1 2#a") == " 1 2");
    CHECK(without_comment("1.#QNAN 2 # 1.#INF") == "1.#QNAN 2 ");
    CHECK(without_comment("1.#J") == "1.#J");
    CHECK(without_comment("# a") == "");
}

TEST_CASE("a comment after a name is not part of it")
{
    CHECK(name_in(" wood # oak") == "wood");
    CHECK(name_in("Material #25 ") == "Material #25");
    CHECK(name_in("#") == "");
}

TEST_CASE("the ending of a file name may be in upper or lower case")
{
    CHECK(ends_in("room.mtl", ".mtl"));
    CHECK(ends_in("Wood.TgA", ".tga"));
    CHECK_FALSE(ends_in("tga", ".tga"));
    CHECK_FALSE(ends_in("room.mtl.txt", ".mtl"));
}

} // namespace text_words_test
