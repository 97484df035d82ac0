#include "export/svg/svg_plot.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace svg_plot_test {

using namespace multipath;

namespace {

Plot unit_plot()
{
    const std::vector<PlotTick> ticks = {{0.0, "0"}, {1.0, "1"}};
    return {50, 20, 200, 100, "a < b", {"x & y", 0.0, 1.0, ticks}, {"up", 0.0, 1.0, ticks}};
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

std::vector<std::string> labels(const PlotAxis& axis)
{
    std::vector<std::string> result;
    for (const PlotTick& tick : axis.ticks)
        result.push_back(tick.label);
    return result;
}

/// The outline of a mark, from its place on.
std::string outline(std::size_t series)
{
    const std::string text = svg_marks({{0, 0}}, svg_series_mark(series), false);
    const std::size_t begin = text.find("M0 0") + 4;
    return text.substr(begin, text.find('"', begin) - begin);
}

} // namespace

TEST_CASE("values stand where the axes say, with y upwards")
{
    const std::string dots = svg_dots(unit_plot(), {{0, 0}, {1, 1}, {0.5, 0.25}}, "#000000", 2.0);
    CHECK(contains(dots, "d=\"M50 120h0M250 20h0M150 95h0\""));

    Plot shifted = unit_plot();
    shifted.across.low = -3.0;
    shifted.across.high = 5.0;
    shifted.up.low = 2.0;
    shifted.up.high = 4.0;
    CHECK(contains(svg_dots(shifted, {{-3, 2}, {1, 3.5}}, "#000000", 2.0), "d=\"M50 120h0M150 45h0\""));
}

TEST_CASE("lengths have one decimal at most, and zero has no sign")
{
    const std::string dots = svg_dots({0, 0, 100, 100, "", {"", 0, 1, {}}, {"", 0, 1, {}}},
                                      {{1.0 / 3.0, 0.5}, {-1e-9, 1.0 + 1e-9}}, "#000000", 2.0);
    CHECK(contains(dots, "d=\"M33.3 50h0M0 0h0\""));
}

TEST_CASE("axes label every tick and every title, with XML's special characters escaped")
{
    const std::string axes = svg_axes(unit_plot());
    for (const char* part : {">0<", ">1<", ">x &amp; y<", ">up<", ">a &lt; b<"})
        CHECK_MESSAGE(contains(axes, part), part);
    CHECK_FALSE(contains(axes, "a < b"));
}

TEST_CASE("what follows a '^' in a tick's label is raised, and nowhere else")
{
    Plot plot = unit_plot();
    plot.across.ticks = {{0.5, "10^<2"}};
    plot.title = "2^20 lines";
    const std::string axes = svg_axes(plot);
    CHECK(contains(axes, ">10<tspan dy=\"-4\" font-size=\"8.5\">&lt;2</tspan></text>"));
    CHECK(contains(axes, ">2^20 lines</text>"));
}

TEST_CASE("minor ticks are shorter than those with labels, and the grid leaves them out")
{
    Plot plot = unit_plot();
    plot.across.minor_ticks = {0.25};
    plot.up.minor_ticks = {0.5};
    const std::string axes = svg_axes(plot);
    for (const char* part : {"M250 120v4", "M100 120v2", "M50 20h-4", "M50 70h-2"})
        CHECK_MESSAGE(contains(axes, part), part);
    CHECK(contains(svg_grid(plot), "d=\"M50 20v100M250 20v100M50 120h200M50 20h200\""));
}

TEST_CASE("the title of the axis up is turned about its place, as far from the frame as asked for")
{
    Plot plot = unit_plot();
    CHECK(contains(svg_axes(plot), "rotate(-90 16 70)"));
    plot.up_title_distance = 44.5;
    CHECK(contains(svg_axes(plot), "rotate(-90 5.5 70)"));
    CHECK(contains(svg_axes(plot), "x=\"5.5\" y=\"70\""));
}

TEST_CASE("an arrow of no length has no head, and none of its numbers is undefined")
{
    const std::string still = svg_arrow(unit_plot(), {0.5, 0.5}, {0.5, 0.5}, "#000000");
    CHECK(contains(still, "d=\"M150 70L150 70\""));
    const std::string flat = svg_arrow(unit_plot(), {0.0, 0.0}, {1.0, 0.0}, "#000000");
    CHECK(contains(flat, "d=\"M50 120L250 120M244 122.7L250 120L244 117.3\"")); // head 6 long, 0.45 * 6 to either side
}

TEST_CASE("the ramp goes from dark to bright")
{
    CHECK(svg_ramp_colour(0.0) == "#0a286e");
    CHECK(svg_ramp_colour(1.0) == "#f09614");
}

TEST_CASE("the head gives the size, the title and the comments, and paints the background white")
{
    const std::string head = svg_head(300, 200.5, "1 < 2", {"command: --count 5", "bell \a"});
    for (const char* part : {"viewBox=\"0 0 300 200.5\"", "<title>1 &lt; 2</title>", "command: --count 5\n", "bell ?\n",
                             "fill=\"#ffffff\""})
        CHECK_MESSAGE(contains(head, part), part);
}

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

TEST_CASE("twelve series differ in shape alone, eight in colour alone, ninety-six in one or the other")
{
    std::set<std::string> shapes;
    std::set<std::string> colours;
    std::set<std::string> marks;
    for (std::size_t k = 0; k < 96; ++k) {
        if (k < 12)
            shapes.insert(outline(k));
        if (k < 8)
            colours.insert(svg_series_mark(k).colour);
        marks.insert(svg_series_mark(k).colour + outline(k));
    }
    CHECK(shapes.size() == 12);
    CHECK(colours.size() == 8);
    CHECK(marks.size() == 96);
}

TEST_CASE("marks stand at their places, filled in their colour or white inside")
{
    const MarkStyle style = {"#123456", 1}; // a square
    const std::string filled = svg_marks({{10, 20}, {30.25, 40}}, style, false);
    CHECK(contains(filled, "d=\"M10 20m-3.6 -3.6h7.2v7.2h-7.2zM30.3 40m-3.6 -3.6h7.2v7.2h-7.2z\""));
    CHECK(contains(filled, "fill=\"#123456\" stroke=\"#ffffff\""));
    CHECK(contains(svg_marks({{10, 20}}, style, true), "fill=\"#ffffff\" stroke=\"#123456\""));
}

TEST_CASE("a line joins its places with the dashes asked for, a bar its ends")
{
    CHECK(svg_polyline({{1, 2}, {3, 4}, {5, 6.5}}, {"#000000", 1.5}) ==
          "<path d=\"M1 2L3 4L5 6.5\" fill=\"none\" stroke=\"#000000\" stroke-width=\"1.5\"/>\n");
    CHECK(contains(svg_polyline({{1, 2}, {3, 4}}, {"#000000", 1.0, "6 4"}), "stroke-dasharray=\"6 4\""));
    CHECK(contains(svg_bars({{1, 2, 3}, {4, 5, 6}}, {"#000000", 1.0}), "d=\"M1 2V3M4 5V6\""));
}

TEST_CASE("nothing to draw is no element")
{
    CHECK(svg_marks({}, svg_series_mark(0), false).empty());
    CHECK(svg_polyline({{1, 2}}, {"#000000", 1.0}).empty());
    CHECK(svg_bars({}, {"#000000", 1.0}).empty());
}

} // namespace svg_plot_test
