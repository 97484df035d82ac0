#include "base/elementary.h"

#include "sampling/random.h"

#include <doctest/doctest.h>
#include <string>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace elementary_test {

using namespace multipath;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The largest relative difference to the C library's function for long double, for many x = low (high / low)^u.
template <class Ours, class Theirs>
double largest_error(double low, double high, const Ours& ours, const Theirs& theirs)
{
    double largest = 0.0;
    for (std::uint64_t k = 0; k < 20000; ++k) {
        const double u = bits_to_unit(random_bits(7, k));
        const double x = low > 0.0 ? low * std::pow(high / low, u) : low + u * (high - low);
        const auto exact = static_cast<long double>(theirs(static_cast<long double>(x)));
        if (exact != 0.0L)
            largest = std::max(largest, static_cast<double>(std::abs((ours(x) - exact) / exact)));
    }
    return largest;
}

} // namespace

TEST_CASE("elementary functions are right to two units in the last place")
{
    constexpr double two_units = 4.4e-16;
    CHECK(largest_error(-700.0, 700.0, elementary::exp, [](long double x) { return std::exp(x); }) < two_units);
    CHECK(largest_error(-1.0, 1.0, elementary::exp, [](long double x) { return std::exp(x); }) < two_units);
    CHECK(largest_error(1e-300, 1e300, elementary::log, [](long double x) { return std::log(x); }) < two_units);
    CHECK(largest_error(0.5, 2.0, elementary::log, [](long double x) { return std::log(x); }) < two_units);
    CHECK(largest_error(1e-9, 1e9, elementary::log10, [](long double x) { return std::log10(x); }) < 1.5 * two_units);
    CHECK(largest_error(1e-9, 1e9, elementary::atan, [](long double x) { return std::atan(x); }) < two_units);
    CHECK(largest_error(1e-12, 1e200, elementary::asinh, [](long double x) { return std::asinh(x); }) <
          2.0 * two_units);
    CHECK(largest_error(1e-9, 1.0, elementary::sin, [](long double x) { return std::sin(x); }) < two_units);
    CHECK(largest_error(1e-9, 1.0, elementary::cos, [](long double x) { return std::cos(x); }) < two_units);
    CHECK(largest_error(-1.4, 1.4, elementary::tan, [](long double x) { return std::tan(x); }) < 4.0 * two_units);
    CHECK(largest_error(
              1e-160, 1e160, [](double x) { return elementary::hypot(x, 0.7 * x); },
              [](long double x) { return std::hypot(x, 0.7L * x); }) < two_units);
    CHECK(largest_error(
              1e-6, 1e6, [](double x) { return elementary::pow(x, 2.4); },
              [](long double x) { return std::pow(x, static_cast<long double>(2.4)); }) < 1e-14);
    for (int k = -20; k <= 20; ++k) {
        CHECK(elementary::sin(0.3 * k) == doctest::Approx(std::sin(0.3 * k)).epsilon(1e-15));
        CHECK(elementary::cos(0.3 * k) == doctest::Approx(std::cos(0.3 * k)).epsilon(1e-15));
        for (int j = -20; j <= 20; ++j)
            CHECK(elementary::atan2(0.3 * k, 0.2 * j) == doctest::Approx(std::atan2(0.3 * k, 0.2 * j)).epsilon(1e-15));
    }
}

TEST_CASE("elementary functions are exact where one expects it")
{
    for (int n = 0; n <= 22; ++n) {
        const double power = elementary::pow(10.0, n);
        CHECK(power == std::pow(10.0, n));
        CHECK(elementary::pow(10.0, -n) == std::stod("1e-" + std::to_string(n))); // some C libraries' pow errs here
        CHECK(elementary::log10(power) == n);
        CHECK(elementary::log10(1.0 / power) == -n);
    }
    CHECK(elementary::exp(0.0) == 1.0);
    CHECK(elementary::hypot(3.0, 4.0) == 5.0);
    CHECK(elementary::sin(0.0) == 0.0);
    CHECK(elementary::cos(0.0) == 1.0);
}

TEST_CASE("elementary functions take what is no number, endless or 0 as the C library does")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double x : {0.0, -0.0, 1.0, -1.0, 1e-310, 800.0, -800.0, infinity, -infinity, nan}) {
        CAPTURE(x);
        const auto same = [](double a, double b) {
            return std::isnan(b) ? std::isnan(a) : a == b && std::signbit(a) == std::signbit(b);
        };
        if (std::abs(x) != 1.0 && x != 1e-310) { // the last bit
            CHECK(same(elementary::exp(x), std::exp(x)));
        }
        if (!(x > 1.0 && x < infinity) && !(x > 0.0 && x < 1e-300)) {
            CHECK(same(elementary::log(x), std::log(x)));
            CHECK(same(elementary::log10(x), std::log10(x)));
        }
        for (const double y : {0.0, -0.0, 1.0, -1.0, infinity, -infinity, nan})
            CHECK(same(elementary::atan2(y, x == 800.0 || x == -800.0 ? 0.0 : x),
                       std::atan2(y, x == 800.0 || x == -800.0 ? 0.0 : x)));
        CHECK(same(elementary::hypot(x, 0.0), std::hypot(x, 0.0)));
        CHECK((std::isfinite(x) || same(elementary::asinh(x), std::asinh(x))));
    }
    CHECK(elementary::pow(0.0, 2.4) == 0.0);
    CHECK(elementary::pow(2.0, infinity) == infinity);
    CHECK(std::isnan(elementary::pow(-2.0, 0.5)));
}

} // namespace elementary_test
