#include "export/log_axis.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace log_axis_test {

using namespace multipath;

namespace {

std::vector<std::string> labels(const PlotAxis& axis)
{
    std::vector<std::string> result;
    for (const PlotTick& tick : axis.ticks)
        result.push_back(tick.label);
    return result;
}

} // namespace

TEST_CASE("powers of ten are labelled, and eight minor ticks fill the interval between two of them")
{
    const PlotAxis axis = log_axis("error", -2.0, 1.0);
    CHECK(axis.title == "error");
    CHECK(labels(axis) == std::vector<std::string>{"10^\u22122", "10^\u22121", "10^0", "10^1"});
    CHECK(axis.ticks[1].value == -1.0);
    const auto between = [](double value) { return value > -1.0 && value < 0.0; };
    CHECK(std::count_if(axis.minor_ticks.begin(), axis.minor_ticks.end(), between) == 8); // 0.2, 0.3, ... 0.9
    CHECK(std::any_of(axis.minor_ticks.begin(), axis.minor_ticks.end(),
                      [](double value) { return std::abs(value - std::log10(0.3)) < 1e-12; }));
}

TEST_CASE("wherever the data lie, they have room, and at least two labels stand within the axis")
{
    for (const double width : {0.0, 0.1, 0.5, 0.9, 1.5, 5.0, 13.0, 40.0})
        for (double low = -3.0; low < -1.9; low += 0.05) {
            const PlotAxis axis = log_axis("", low, low + width);
            CHECK(axis.low <= low - 0.1);
            CHECK(axis.high >= low + width + 0.1);
            CHECK(axis.ticks.size() >= 2);
            CHECK(axis.ticks.size() <= 15);
            for (const PlotTick& tick : axis.ticks)
                CHECK((tick.value >= axis.low && tick.value <= axis.high));
            for (const double tick : axis.minor_ticks)
                CHECK((tick >= axis.low && tick <= axis.high));
        }
}

TEST_CASE("with one power of ten, 2 and 5 times the powers are labelled as well")
{
    const PlotAxis axis = log_axis("", std::log10(4000.0), std::log10(30000.0)); // 2965 ... 40470
    CHECK(labels(axis) == std::vector<std::string>{"5\u00b710^3", "10^4", "2\u00b710^4"});
    CHECK(axis.ticks[2].value == doctest::Approx(std::log10(20000.0)));
}

TEST_CASE("where there are too many powers every other one is labelled and the rest are minor ticks")
{
    const PlotAxis axis = log_axis("", 0.0, 20.0);
    CHECK(labels(axis).front() == "10^0");
    CHECK(labels(axis)[1] == "10^2");
    CHECK(axis.minor_ticks.front() == 1.0);
    CHECK(axis.minor_ticks.size() == 10);
}

TEST_CASE("an axis without data is one of numbers")
{
    const PlotAxis axis = log_axis("", INFINITY, -INFINITY);
    CHECK(axis.low == doctest::Approx(-0.13));
    CHECK(axis.high == doctest::Approx(1.13));
}

} // namespace log_axis_test
