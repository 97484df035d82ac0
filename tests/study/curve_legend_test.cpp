#include "study/curve_legend.h"

#include <doctest/doctest.h>
#include <set>

namespace curve_legend_test {

using namespace multipath;

namespace {

/// The places of all texts from left to right.
std::set<double> columns(const std::string& svg)
{
    std::set<double> result;
    for (std::size_t at = svg.find("<text x=\""); at != std::string::npos; at = svg.find("<text x=\"", at + 1))
        result.insert(std::stod(svg.substr(at + 9)));
    return result;
}

CurveLegend legend(std::size_t curves, const std::string& label)
{
    std::vector<PlottedCurve> plotted;
    for (std::size_t k = 0; k < curves; ++k)
        plotted.push_back({svg_series_mark(k), {{3.0, -3.0}}, {}, {}, PowerLaw{1.0, -1.0, 0.01, 12}, {}});
    return curve_legend(plotted, std::vector<std::string>(curves, label), 40.0, 500.0, 580.0);
}

} // namespace

TEST_CASE("a slope has the half width of its interval, with three decimals where two would show nothing")
{
    PowerLaw law;
    law.exponent = -1.104;
    law.exponent_error = 0.01;
    law.points = 12; // Student's t for 10 degrees of freedom is 2.228
    CHECK(slope_text(law) == "slope \u22121.10 \u00b1 0.02");
    law.exponent_error = 0.001;
    CHECK(slope_text(law) == "slope \u22121.104 \u00b1 0.002");
    law.exponent = 0.25;
    CHECK(slope_text(law) == "slope 0.250 \u00b1 0.002");
    CHECK(slope_text({}) == "no slope: points too few or too close");
}

TEST_CASE("many curves stand in two columns if their labels are short, in one otherwise")
{
    CHECK(columns(legend(4, "short").text).size() == 2); // labels and slopes
    CHECK(columns(legend(12, "short").text).size() == 4);
    CHECK(columns(legend(12, std::string(40, 'x')).text).size() == 2);
    CHECK(legend(12, "short").height == doctest::Approx(legend(6, std::string(40, 'x')).height));
    CHECK(legend(11, "short").height == legend(12, "short").height);
}

TEST_CASE("the legend lies between its left edge and its width, below its top")
{
    for (const std::size_t curves : {std::size_t(1), std::size_t(5), std::size_t(12)}) {
        const CurveLegend drawn = legend(curves, "first-shot, sobol");
        const std::set<double> places = columns(drawn.text);
        CHECK(*places.begin() > 40.0);
        CHECK(*places.rbegin() < 40.0 + 580.0 - 100.0); // a slope is some 100 px wide
        CHECK(drawn.height >= 12.0);
    }
}

} // namespace curve_legend_test
