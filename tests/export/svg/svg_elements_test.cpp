#include "export/svg/svg_elements.h"

#include <doctest/doctest.h>
#include <set>

namespace svg_elements_test {

using namespace multipath;

namespace {

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// The outline of a mark, from its place on.
std::string outline(std::size_t series)
{
    const std::string text = svg_marks({{0, 0}}, svg_series_mark(series), false);
    const std::size_t begin = text.find("M0 0") + 4;
    return text.substr(begin, text.find('"', begin) - begin);
}

} // namespace

TEST_CASE("twelve series differ in shape alone, seven in colour alone, eighty-four in one or the other")
{
    std::set<std::string> shapes;
    std::set<std::string> colours;
    std::set<std::string> marks;
    for (std::size_t k = 0; k < 84; ++k) {
        if (k < 12)
            shapes.insert(outline(k));
        if (k < 7)
            colours.insert(svg_series_mark(k).colour);
        marks.insert(svg_series_mark(k).colour + outline(k));
    }
    CHECK(shapes.size() == 12);
    CHECK(colours.size() == 7);
    CHECK(marks.size() == 84);
}

TEST_CASE("marks stand at their places, filled in their colour or white inside")
{
    const MarkStyle style = {"#123456", MarkShape::square};
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

} // namespace svg_elements_test
