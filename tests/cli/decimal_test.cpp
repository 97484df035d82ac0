#include "cli/decimal.h"

#include <doctest/doctest.h>

#include <initializer_list>
#include <locale>

namespace decimal_test {

using namespace multipath;

namespace {

/// Writes 0.5 as 0,5, as many users' locales do.
class CommaPoint : public std::numpunct<char>
{
protected:
    char do_decimal_point() const override { return ','; }
};

} // namespace

TEST_CASE("a decimal keeps the digits without zeros at the ends, and the power of ten")
{
    const auto check = [](const char* text, bool negative, const char* digits, int exponent) {
        const std::optional<Decimal> decimal = parse_decimal(text);
        REQUIRE_MESSAGE(decimal, text);
        CHECK_MESSAGE(decimal->negative == negative, text);
        CHECK_MESSAGE(decimal->digits == digits, text);
        CHECK_MESSAGE(decimal->exponent == exponent, text);
    };
    check("12.5", false, "125", -1);
    check("-0012.500", true, "125", -1);
    check("1e6", false, "1", 6);
    check("1.5E+3", false, "15", 2);
    check("2.e-3", false, "2", -3);
    check(".5", false, "5", -1);
}

TEST_CASE("text that is not entirely a decimal is no decimal")
{
    for (const char* text : {"",   "-",   ".",     "e5",   "1e",  "1e+", "1e123456", "1,5",   "1 ",    " 1",
                             "+1", "--1", "1.2.3", "0x10", "nan", "inf", "infinity", "1e5.5", "1_000", "\xd9\xa1"})
        CHECK_MESSAGE(!parse_decimal(text), text);
}

TEST_CASE("whole values are exact up to 2^64 - 1 and capped there")
{
    const auto whole = [](const char* text) { return whole_value(*parse_decimal(text)); };
    CHECK(whole("0") == 0u);
    CHECK(whole("0.000") == 0u);
    CHECK(whole("1.5e1") == 15u);
    CHECK(whole("1500e-2") == 15u);
    CHECK(whole("9007199254740993") == 9007199254740993u); // 2^53 + 1, which a double cannot hold
    CHECK(whole("18446744073709551614") == 18446744073709551614u);
    CHECK(whole("18446744073709551616") == 18446744073709551615u);
    CHECK(whole("99999999999999999999") == 18446744073709551615u);
    CHECK(whole("1e99999") == 18446744073709551615u);
    CHECK(!whole("0.5"));
    CHECK(!whole("-1"));
}

TEST_CASE("real values are the doubles that the compiler reads from the same text")
{
    const auto real = [](const char* text) { return real_value(*parse_decimal(text)); };
    CHECK(real("0.1") == 0.1);
    CHECK(real("-2.5e-3") == -2.5e-3);
    CHECK(real("3.14159265358979323846264338327950288419716939937510582097494459") == 3.14159265358979323846);
    CHECK(real("1.7976931348623157e308") == 1.7976931348623157e308);
    CHECK(real("0e99999") == 0.0);
    CHECK(!real("1e309"));
    CHECK(!real("1e-400"));
}

TEST_CASE("real values do not depend on the locale")
{
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaPoint));
    const std::optional<double> value = real_value(*parse_decimal("1234.5"));
    std::locale::global(before);
    CHECK(value == 1234.5);
}

} // namespace decimal_test
