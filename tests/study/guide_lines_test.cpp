#include "study/guide_lines.h"

#include <cstdio>
#include <doctest/doctest.h>

namespace guide_lines_test {

using namespace multipath;

namespace {

/// 100 px per decade, both ways.
Plot five_decades()
{
    return {50, 20, 500, 500, "", {"", 0.0, 5.0, {}}, {"", -5.0, 0.0, {}}};
}

/// The ends of the lines of a drawing, two by two.
std::vector<SvgPoint> line_ends(const std::string& svg)
{
    std::vector<SvgPoint> ends;
    for (std::size_t at = svg.find("d=\"M"); at != std::string::npos; at = svg.find("d=\"M", at + 1)) {
        SvgPoint from{};
        SvgPoint to{};
        REQUIRE(std::sscanf(svg.c_str() + at, "d=\"M%lf %lfL%lf %lf", &from.x, &from.y, &to.x, &to.y) == 4);
        ends.push_back(from);
        ends.push_back(to);
    }
    return ends;
}

std::vector<SvgPoint> text_places(const std::string& svg)
{
    std::vector<SvgPoint> places;
    for (std::size_t at = svg.find("<text"); at != std::string::npos; at = svg.find("<text", at + 1)) {
        SvgPoint place{};
        REQUIRE(std::sscanf(svg.c_str() + at, "<text x=\"%lf\" y=\"%lf\"", &place.x, &place.y) == 2);
        places.push_back(place);
    }
    return places;
}

} // namespace

TEST_CASE("the guides begin at one point and fall by 1 and 1.25 decades in a decade")
{
    const std::vector<SvgPoint> ends = line_ends(guide_lines(five_decades(), {}));
    REQUIRE(ends.size() == 4);
    CHECK((ends[0].x == ends[2].x && ends[0].y == ends[2].y));
    CHECK(ends[1].x - ends[0].x == doctest::Approx(200.0)); // two decades
    CHECK(ends[1].y - ends[0].y == doctest::Approx(200.0));
    CHECK(ends[3].y - ends[0].y == doctest::Approx(250.0));
}

// Each of the curves leaves a corner of the plot free in which the guides can keep 12 px, more than a label is high.
TEST_CASE("the guides and their labels go where the curves are not, be it below, between or above them")
{
    const std::vector<std::pair<SvgPoint, SvgPoint>> curves = {{{50, 20}, {550, 520}},
                                                               {{50, 520}, {550, 20}},
                                                               {{50, 40}, {550, 60}},
                                                               {{50, 480}, {550, 500}},
                                                               {{70, 20}, {90, 520}}};
    for (const auto& [from, to] : curves) {
        const std::vector<SvgPoint> curve = points_of_line(from, to, 2.0);
        const std::string svg = guide_lines(five_decades(), curve);
        const std::vector<SvgPoint> ends = line_ends(svg);
        CHECK(clearance(points_of_line(ends[0], ends[1], 2.0), curve) > 12.0);
        CHECK(clearance(points_of_line(ends[2], ends[3], 2.0), curve) > 12.0);
        CHECK(clearance(text_places(svg), curve) > 12.0);
    }
}

TEST_CASE("where there is little room the guides are shorter, and their labels still apart")
{
    std::vector<SvgPoint> all_but_a_corner = points_of_box({50, 20, 550, 300}, 10.0);
    const std::vector<SvgPoint> right = points_of_box({300, 300, 550, 520}, 10.0);
    all_but_a_corner.insert(all_but_a_corner.end(), right.begin(), right.end());
    const std::string svg = guide_lines(five_decades(), all_but_a_corner);
    const std::vector<SvgPoint> ends = line_ends(svg);
    CHECK(ends[1].x - ends[0].x < 150.0);
    for (const SvgPoint end : ends)
        CHECK((end.x < 300.0 && end.y > 300.0));
    const std::vector<SvgPoint> labels = text_places(svg);
    REQUIRE(labels.size() == 2);
    CHECK(labels[1].y - labels[0].y > 12.0); // letters are 11 px high
}

TEST_CASE("a level goes from edge to edge, and its label stands at the end that is free")
{
    const Plot plot = five_decades();
    const LabelledLevel left = labelled_level(plot, -3.0, "level", points_of_box({300, 250, 550, 390}, 10.0));
    const std::vector<SvgPoint> ends = line_ends(left.text);
    REQUIRE(ends.size() == 2);
    CHECK((ends[0].x == 50 && ends[0].y == 320 && ends[1].x == 550 && ends[1].y == 320));
    CHECK(text_places(left.text).at(0).x < 100.0);
    const LabelledLevel right = labelled_level(plot, -3.0, "level", points_of_box({50, 250, 300, 390}, 10.0));
    CHECK(text_places(right.text).at(0).x > 500.0);
    const LabelledLevel below = labelled_level(plot, -3.0, "level", points_of_box({50, 250, 550, 319}, 10.0));
    CHECK(text_places(below.text).at(0).y > 320.0);
    const LabelledLevel lowest = labelled_level(plot, -4.95, "level", points_of_box({50, 400, 550, 510}, 10.0));
    CHECK(text_places(lowest.text).at(0).y < 515.0);     // below the line there is no room
    CHECK(clearance(lowest.points, {{300, 515}}) < 5.0); // the line is an obstacle
}

} // namespace guide_lines_test
