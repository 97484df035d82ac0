#include "study/curve.h"

#include "sampling/random.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <initializer_list>
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

/// Points at the ratios 1/16 to 16 and of both rules, (3) at 1 and the pilot at sqrt(2). Each execution is off the law
/// 2 (1 + 1/ratio) + 1 + ratio, whose parts are raised to a power, by up to 20 % as a whole and by up to 5 % at each
/// point.
std::vector<CurvePoint> points_with(std::uint64_t trial, std::uint64_t executions, double power, double scatter = 1.0)
{
    std::vector<CurvePoint> points;
    for (std::uint64_t k = 0; k < 11; ++k) {
        CurvePoint point;
        point.setting = k < 9 ? std::exp2(static_cast<double>(k) - 4.0) : k == 9 ? 1.0 : std::sqrt(2.0);
        point.rule = k < 9 ? "" : k == 9 ? "auto" : "measured";
        for (std::uint64_t run = 0; run < executions; ++run) {
            const auto off = [&](std::uint64_t index, double most) {
                return 1.0 + scatter * most * (2.0 * bits_to_unit(random_bits(trial, 16 * run + index)) - 1.0);
            };
            CurvePoint execution = point;
            execution.executions.clear();
            execution.relative =
                off(15, 0.2) * off(k, 0.05) *
                (2.0 * std::pow(1.0 + 1.0 / point.setting, power) + std::pow(1.0 + point.setting, power));
            point.executions.push_back(execution);
        }
        for (const CurvePoint& execution : point.executions)
            point.relative += execution.relative / static_cast<double>(executions);
        points.push_back(point);
    }
    return points;
}

/// Keeps only the points with these indices.
std::vector<CurvePoint> only(const std::vector<CurvePoint>& points, std::initializer_list<std::size_t> kept)
{
    std::vector<CurvePoint> chosen;
    for (const std::size_t k : kept)
        chosen.push_back(points[k]);
    return chosen;
}

} // namespace

// At its best ratio sqrt(2) the law is (sqrt(2) + 1)^2, at 1 it is 6.
TEST_CASE("points on the law of ratios give it back with the losses of both rules")
{
    for (const std::uint64_t executions : {1u, 3u}) {
        const auto found = ratio_findings(points_with(1, executions, 1.0, 0.0));
        REQUIRE(found);
        REQUIRE(found->law);
        CHECK(found->law->local == doctest::Approx(2.0).epsilon(1e-9));
        CHECK(found->law->global == doctest::Approx(1.0).epsilon(1e-9));
        CHECK(found->best.value == doctest::Approx(std::sqrt(2.0)).epsilon(1e-9));
        CHECK(found->least == doctest::Approx(3.0 + 2.0 * std::sqrt(2.0)).epsilon(1e-9));
        CHECK(found->loss.at("auto").value == doctest::Approx(6.0 / found->least).epsilon(1e-9));
        CHECK(found->loss.at("measured").value == doctest::Approx(1.0).epsilon(1e-9));
        CHECK(found->formula_over_pilot->value == doctest::Approx(6.0 / found->least).epsilon(1e-9));
        CHECK(std::isinf(found->best.high) == (executions == 1));
    }
}

TEST_CASE("too few ratios give no findings, and a least error at none of them no law")
{
    std::vector<CurvePoint> points = points_with(1, 3, 1.0, 0.0);
    CHECK_FALSE(ratio_findings(only(points, {0, 1, 2})));
    CHECK_FALSE(ratio_findings(only(points, {0, 1, 1, 0, 1})));
    const auto low = ratio_findings(only(points, {0, 1, 2, 3}));
    REQUIRE(low);
    CHECK_FALSE(low->law);
    CHECK(low->best.value == 0.5); // the last of them
    CHECK(std::isinf(low->best.high));
    CHECK(low->least == points[3].relative);

    points.back().setting = std::numeric_limits<double>::infinity(); // the pilot took no global lines
    const auto without = ratio_findings(points);
    CHECK(without->law);
    CHECK(without->loss.count("measured") == 0);
    CHECK_FALSE(without->formula_over_pilot);
    for (std::size_t k = 3; k < points.size(); ++k)
        points[k].above_reference = false;
    CHECK_FALSE(ratio_findings(points));
}

// Six executions, two thousand times: the true values are those of the law. The binomial standard deviation is 0.5 %,
// uniform errors instead of normal ones move it by less than 1 %. Fits to the means, as if their points were
// independent, would know nothing of what an execution has in common. (3) loses 2.9 %: its interval stays above 1.
TEST_CASE("intervals of 95 % over executions hold the truth, and 5 % of true laws are given up")
{
    constexpr int trials = 2000;
    const double least = 3.0 + 2.0 * std::sqrt(2.0);
    int best = 0;
    int loss = 0;
    int compared = 0;
    int given_up = 0;
    const auto holds = [](const Estimate& e, double truth) { return e.low <= truth && truth <= e.high ? 1 : 0; };
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
        const auto found = ratio_findings(points_with(trial, 6, 1.0));
        given_up += found->law ? 0 : 1;
        if (!found->law)
            continue;
        best += holds(found->best, std::sqrt(2.0));
        loss += holds(found->loss.at("auto"), 6.0 / least);
        compared += holds(*found->formula_over_pilot, 6.0 / least);
    }
    const double kept = trials - given_up;
    CHECK(given_up / static_cast<double>(trials) == doctest::Approx(0.05).epsilon(0.3));
    CHECK(best / kept == doctest::Approx(0.95).epsilon(0.02));
    CHECK(loss / kept == doctest::Approx(0.95).epsilon(0.02));
    CHECK(compared / kept == doctest::Approx(0.95).epsilon(0.02));
}

TEST_CASE("an error that falls faster than 1/N is told from the law, and the least measured point is taken")
{
    int given_up = 0;
    for (std::uint64_t trial = 0; trial < 100; ++trial) {
        const auto points = points_with(trial, 6, 1.3);
        const auto found = ratio_findings(points);
        if (found->law)
            continue;
        ++given_up;
        double least = points[0].relative;
        for (const CurvePoint& point : points)
            least = std::min(least, point.relative);
        CHECK(*found->probability < 0.05);
        CHECK(found->least == doctest::Approx(least));
    }
    CHECK(given_up > 90);
}

} // namespace curve_test
