#include "base/errors.h"
#include "cli/options/number_text.h"

#include "cli/options/command_line.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <locale>
#include <string>

namespace number_text_test {

using namespace multipath;

namespace {

std::uint64_t count(std::string_view text)
{
    return read_count("--lines", text);
}

double real(const std::string& text)
{
    return read_real("--scale", text, -std::numeric_limits<double>::max());
}

/// Writes 0.5 as 0,5, as many users' locales do.
class CommaPoint : public std::numpunct<char>
{
protected:
    char do_decimal_point() const override { return ','; }
};

template <class Read>
void check_refused(Read read, std::initializer_list<const char*> texts)
{
    for (const char* text : texts)
        CHECK_THROWS_AS_MESSAGE(read("--option", text), UsageError, text);
}

} // namespace

TEST_CASE("a million can be written in every customary way")
{
    for (const char* text : {"1000000", "1e6", "1E6", "1M", "1.0M", "1000k", "1000K", "0.001G", "10^6", "1000^2"})
        CHECK_MESSAGE(count(text) == 1000000u, text);
}

TEST_CASE("counts are exact up to 2^63")
{
    CHECK(count("0") == 0u);
    CHECK(count("1.5M") == 1500000u);
    CHECK(count("2^20") == 1048576u);
    CHECK(count("2^53") + 1 == count("9007199254740993"));
    CHECK(count("2^63") == std::uint64_t(1) << 63);
    CHECK(count("9223372036854775808") == std::uint64_t(1) << 63);
    CHECK(count("7^0") == 1u);
    CHECK(count("0^3") == 0u);
    CHECK(count("1^999999") == 1u);
}

TEST_CASE("counts in decimals are whole if their digits are")
{
    CHECK(count("0.000") == 0u);
    CHECK(count("1.5e1") == 15u);
    CHECK(count("1500e-2") == 15u);
    CHECK(count("0015") == 15u);
    CHECK(count("15.") == 15u);
    CHECK(count(".15E+2") == 15u);
}

TEST_CASE("what is not a count is refused with the ways to write one")
{
    CHECK_THROWS_WITH_AS(count("ten"),
                         "--lines: expected a count from 0 to 2^63 such as 1000000, 1e6, 1M or 2^20, got 'ten'",
                         UsageError);
    check_refused([](auto option, auto text) { return read_count(option, text); },
                  {"",   " ",     "-1",   "-0",    "+1",    "0.5",       "1.5",   "1e-1", "1m",   "1T",
                   "M",  "1 M",   "1MM",  "1,000", "1,5",   "1.000.000", "nan",   "inf",  "0x10", "2^",
                   "^2", "2^2^2", "2^-1", "2^0.5", "2^20k", "-2^2",      "2**20", "1e",   "1\n"});
}

TEST_CASE("a count outside its range is refused with the range")
{
    CHECK_THROWS_WITH_AS(count("1e20"),
                         "--lines: expected a count from 0 to 2^63 such as 1000000, 1e6, 1M or 2^20, got '1e20'",
                         UsageError);
    CHECK_THROWS_WITH_AS(count("2^64"),
                         "--lines: expected a count from 0 to 2^63 such as 1000000, 1e6, 1M or 2^20, got '2^64'",
                         UsageError);
    CHECK_THROWS_WITH_AS(count("3^5000"),
                         "--lines: expected a count from 0 to 2^63 such as 1000000, 1e6, 1M or 2^20, got '3^5000'",
                         UsageError);
    CHECK_THROWS_WITH_AS(
        count("9223372036854775809"),
        "--lines: expected a count from 0 to 2^63 such as 1000000, 1e6, 1M or 2^20, got '9223372036854775809'",
        UsageError);
    CHECK_THROWS_WITH_AS(read_count("--steps", "0", 1),
                         "--steps: expected a count from 1 to 2^63 such as 1000000, 1e6, 1M or 2^20, got '0'",
                         UsageError);
    CHECK_THROWS_WITH_AS(read_count("--threads", "65", 1, 64),
                         "--threads: expected a count from 1 to 64 such as 1000000, 1e6, 1M or 2^20, got '65'",
                         UsageError);
    CHECK(read_count("--threads", "64", 1, 64) == 64u);
}

TEST_CASE("real numbers take the same forms, and signs only where the range has room for them")
{
    CHECK(read_real("--scale", "0.25") == 0.25);
    CHECK(read_real("--scale", "1.1M") == 1.1e6);
    CHECK(read_real("--scale", "2^10") == 1024.0);
    CHECK(read_real("--scale", "2^64") == 0x1p64);
    CHECK(read_real("--exposure", "-1.5", -20.0, 20.0) == -1.5);
    CHECK_THROWS_WITH_AS(read_real("--scale", "-1"),
                         "--scale: expected a number from 0 to 1.79769e+308 such as 0.5, 1e-3 or 2M, got '-1'",
                         UsageError);
    CHECK_THROWS_WITH_AS(read_real("--exposure", "21", -20.0, 20.0),
                         "--exposure: expected a number from -20 to 20 such as 0.5, 1e-3 or 2M, got '21'", UsageError);
    CHECK_THROWS_WITH_AS(read_real("--scale", "1,5"),
                         "--scale: expected a number from 0 to 1.79769e+308 such as 0.5, 1e-3 or 2M, got '1,5'",
                         UsageError);
    check_refused([](auto option, auto text) { return read_real(option, text); },
                  {"", "nan", "inf", "-inf", "1e999", "2^1024", "0.5x", "1e-999", "0x1p3", "."});
    CHECK(read_positive("--patch-size", "1e-3") == 1e-3);
    check_refused([](auto option, auto text) { return read_positive(option, text); }, {"0", "-1", "", "nan"});
}

TEST_CASE("real numbers are the doubles that the compiler reads from the same text")
{
    CHECK(real("12.5") == 12.5);
    CHECK(real("-0012.500") == -12.5);
    CHECK(real("2.e-3") == 2e-3);
    CHECK(real(".5") == 0.5);
    CHECK(real("0.1") == 0.1);
    CHECK(real("-2.5e-3") == -2.5e-3);
    CHECK(real("3.14159265358979323846264338327950288419716939937510582097494459") == 3.14159265358979323846);
    CHECK(real("1" + std::string(300, '0') + "e-300") == 1.0);
    CHECK(real("1.7976931348623157e308") == 1.7976931348623157e308);
    CHECK(real("0e99999") == 0.0);
}

TEST_CASE("text that is not entirely a number in a double's range is no number")
{
    for (const char* text :
         {"",      "-",   "e5",  "1e",    "1e+",  "1e123456", "1,5",   "1 ",       " 1",    "+1",     "--1",
          "1.2.3", "nan", "inf", "1e5.5", "0x10", ".",        "1_000", "infinity", "1e309", "1e-400", "\xd9\xa1"})
        CHECK_THROWS_AS_MESSAGE(real(text), UsageError, text);
}

TEST_CASE("real numbers do not depend on the locale")
{
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaPoint));
    const double value = real("1234.5");
    std::locale::global(before);
    CHECK(value == 1234.5);
}

TEST_CASE("a share is a percentage or a fraction, but a bare 1 could be either")
{
    CHECK(read_share("--tolerance", "1%") == 0.01);
    CHECK(read_share("--tolerance", "0.01") == 0.01);
    CHECK(read_share("--tolerance", "100%") == 1.0);
    CHECK(read_share("--tolerance", "0") == 0.0);
    CHECK_THROWS_WITH_AS(read_share("--tolerance", "1"), "--tolerance: expected a share such as 1% or 0.01, got '1'",
                         UsageError);
    check_refused([](auto option, auto text) { return read_share(option, text); },
                  {"", "%", "101%", "-1%", "1%%", "% 1", "5", "nan%", "1,5%"});
}

TEST_CASE("sizes know decimal and binary units")
{
    const auto bytes = [](std::string_view text) { return read_bytes("--memory", text); };
    CHECK(bytes("512MB") == 512000000u);
    CHECK(bytes("512mb") == 512000000u);
    CHECK(bytes("2GB") == 2000000000u);
    CHECK(bytes("1GiB") == 1073741824u);
    CHECK(bytes("1.5MiB") == 1572864u);
    CHECK(bytes("2m") == 2000000u);
    CHECK(bytes("2^30") == 1073741824u);
    CHECK(bytes("77B") == 77u);
    CHECK_THROWS_WITH_AS(bytes("lots"), "--memory: expected a size such as 512MB, 2GB or 1GiB, got 'lots'", UsageError);
    check_refused([](auto option, auto text) { return read_bytes(option, text); },
                  {"", "MB", "-1MB", "0", "0.5B", "1XB", "1 MB", "1e30GB", "infMB", "1MBs"});
}

TEST_CASE("times are in seconds unless a unit says otherwise")
{
    const auto seconds = [](std::string_view text) { return read_seconds("--time", text); };
    CHECK(seconds("30s") == 30.0);
    CHECK(seconds("30") == 30.0);
    CHECK(seconds("5m") == 300.0);
    CHECK(seconds("5min") == 300.0);
    CHECK(seconds("2h") == 7200.0);
    CHECK(seconds("250ms") == 0.25);
    CHECK(seconds("1.5h") == 5400.0);
    CHECK_THROWS_WITH_AS(seconds("soon"), "--time: expected a time such as 30s, 5m, 2h or 250ms, got 'soon'",
                         UsageError);
    check_refused([](auto option, auto text) { return read_seconds(option, text); },
                  {"", "s", "0s", "-1s", "5M", "5k", "1h30m", "5 m", "nan", "1e308h", "1e999s"});
}

TEST_CASE("a vector is three numbers of any sign, a picture's size two counts")
{
    CHECK(read_vec3("--eye", "1,2.5,-3e2") == Vec3{1.0, 2.5, -300.0});
    check_refused([](auto option, auto text) { return read_vec3(option, text); },
                  {"", "1,2", "1,2,3,4", "1,,3", ",,", "1, 2,3", "1;2;3", "1,2,nan", "1,2,3,"});

    CHECK(read_direction("--up", "0,-1,0") == Vec3{0.0, -1.0, 0.0});
    CHECK(read_direction("--up", "0,3e300,0") == Vec3{0.0, std::ldexp(3e300, -998), 0.0}); // 3e300 / 2^998 = 1.1...
    CHECK_THROWS_WITH_AS(read_direction("--up", "0,0,-0"), "--up: expected a direction such as 0,1,0, got '0,0,-0'",
                         UsageError);

    const PixelSize size = read_pixel_size("--size", "800x600", 16384);
    CHECK(size.width == 800);
    CHECK(size.height == 600);
    CHECK_THROWS_WITH_AS(read_pixel_size("--size", "800", 16384),
                         "--size: expected a width and height from 1 to 16384 pixels such as 800x600, got '800'",
                         UsageError);
    check_refused(
        [](auto option, auto text) { return read_pixel_size(option, text, 16384); },
        {"", "x", "800x", "x600", "800x600x3", "0x600", "800x-600", "800*600", "16385x1", "1x16385", "1x0", "1e9x1"});
}

} // namespace number_text_test
