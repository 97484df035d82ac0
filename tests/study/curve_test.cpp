#include "study/curve.h"

#include "sampling/random.h"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>

namespace curve_test {

using namespace multipath;

TEST_CASE("points on a power law give it back, without an error")
{
    std::vector<double> xs;
    std::vector<double> ys;
    for (const double x : {100.0, 200.0, 400.0, 1600.0}) {
        xs.push_back(x);
        ys.push_back(3.0 * std::pow(x, -1.25));
    }
    const auto law = fit_power_law(xs, ys);
    REQUIRE(law);
    CHECK(law->exponent == doctest::Approx(-1.25).epsilon(1e-12));
    CHECK(law->factor == doctest::Approx(3.0).epsilon(1e-12));
    CHECK(law->exponent_error < 1e-12);
    CHECK(law->at(800.0) == doctest::Approx(3.0 * std::pow(800.0, -1.25)));
}

// Three points at ln x = 0, 1, 2 with ln y = 0, 0, 1: slope 1/2, residuals 1/6, -1/3, 1/6, so that the error is
// sqrt((1/36 + 4/36 + 1/36) / 1 / 2) = sqrt(1/12). Student's t for one degree of freedom is 12.7062.
TEST_CASE("the slope's standard error comes from the scatter about the line")
{
    const auto law = fit_power_law({1.0, std::exp(1.0), std::exp(2.0)}, {1.0, 1.0, std::exp(1.0)});
    REQUIRE(law);
    CHECK(law->exponent == doctest::Approx(0.5));
    CHECK(law->exponent_error == doctest::Approx(std::sqrt(1.0 / 12.0)));
    CHECK(exponent_interval(*law) == doctest::Approx(12.7062 * std::sqrt(1.0 / 12.0)));
}

TEST_CASE("fewer than three different abscissae give no law")
{
    CHECK(!fit_power_law({}, {}));
    CHECK(!fit_power_law({1.0, 2.0}, {1.0, 2.0}));
    CHECK(!fit_power_law({1.0, 2.0, 2.0}, {1.0, 2.0, 3.0}));
}

// Seven points, each off by a factor between 0.9 and 1.1, two thousand times: the intervals should hold the truth in 95
// % of cases; the binomial standard deviation is 0.5 %, uniform errors instead of normal ones move it by less than 1 %.
TEST_CASE("intervals of 95 % hold the true slope in 95 % of cases")
{
    constexpr int trials = 2000;
    int held = 0;
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
        std::vector<double> xs;
        std::vector<double> ys;
        for (std::uint64_t k = 0; k < 7; ++k) {
            xs.push_back(std::exp2(static_cast<double>(k)));
            ys.push_back((0.9 + 0.2 * bits_to_unit(random_bits(trial, k))) / xs.back());
        }
        const auto law = fit_power_law(xs, ys);
        held += std::abs(law->exponent + 1.0) <= exponent_interval(*law) ? 1 : 0;
    }
    CHECK(held / static_cast<double>(trials) == doctest::Approx(0.95).epsilon(0.025));
}

namespace {

/// A point with the error local / N_l + global / N_g of N lines, times a factor.
CurvePoint point_at(double ratio, double local, double global, double factor = 1.0)
{
    CurvePoint point;
    point.setting = ratio;
    point.relative = factor * (local * (1.0 + 1.0 / ratio) + global * (1.0 + ratio));
    return point;
}

} // namespace

TEST_CASE("points on the law of ratios give it back, and rules are points like others")
{
    std::vector<CurvePoint> points;
    for (const double ratio : {0.25, 0.5, 1.0, 4.0})
        points.push_back(point_at(ratio, 3e-3, 12e-3));
    points[1].rule = "auto";
    const auto law = fit_ratio(points);
    REQUIRE(law);
    CHECK(law->local == doctest::Approx(3e-3).epsilon(1e-9));
    CHECK(law->global == doctest::Approx(12e-3).epsilon(1e-9));
    CHECK(law->best() == doctest::Approx(0.5).epsilon(1e-9));
    CHECK(law->at(0.5) == doctest::Approx(27e-3).epsilon(1e-9));
    CHECK(law->log_error < 1e-6);
}

TEST_CASE("a least error outside of the ratios, or fewer than three of them, give no law")
{
    std::vector<CurvePoint> points = {point_at(1.0, 1.0, 100.0), point_at(2.0, 1.0, 100.0), point_at(4.0, 1.0, 100.0)};
    CHECK(!fit_ratio(points)); // the least is at 0.1
    points.push_back(point_at(0.05, 1.0, 100.0));
    CHECK(fit_ratio(points));
    points.push_back(point_at(1.0, 1.0, 100.0));
    points.back().setting = std::numeric_limits<double>::infinity(); // the pilot took no global lines
    CHECK(fit_ratio(points)->best() == doctest::Approx(0.1));
    points[1].above_reference = points[2].above_reference = false;
    CHECK(!fit_ratio(points));
}

// As for slopes: the intervals of nine points with errors of up to 10 %.
TEST_CASE("intervals of 95 % hold the best ratio in 95 % of cases")
{
    constexpr int trials = 2000;
    int held = 0;
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
        std::vector<CurvePoint> points;
        for (std::uint64_t k = 0; k < 9; ++k)
            points.push_back(point_at(std::exp2(static_cast<double>(k) - 4.0), 2.0, 1.0,
                                      0.9 + 0.2 * bits_to_unit(random_bits(trial, k))));
        const Estimate best = best_ratio(*fit_ratio(points));
        held += best.low <= std::sqrt(2.0) && std::sqrt(2.0) <= best.high ? 1 : 0;
    }
    CHECK(held / static_cast<double>(trials) == doctest::Approx(0.95).epsilon(0.02));
}

} // namespace curve_test
