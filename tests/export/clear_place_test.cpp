#include "export/clear_place.h"

#include <cmath>
#include <doctest/doctest.h>

namespace clear_place_test {

using namespace multipath;

TEST_CASE("the points of a line and of a box reach their ends and are no farther apart than the step")
{
    const std::vector<SvgPoint> line = points_of_line({1, 2}, {4, 6}, 2.0); // of length 5: three pieces
    REQUIRE(line.size() == 4);
    CHECK((line.front().x == 1 && line.front().y == 2));
    CHECK((line.back().x == 4 && line.back().y == 6));
    CHECK(std::hypot(line[1].x - line[0].x, line[1].y - line[0].y) <= 2.0);
    const std::vector<SvgPoint> box = points_of_box({0, 0, 10, 4}, 5.0); // three columns, two rows
    REQUIRE(box.size() == 6);
    CHECK((box[1].x == 5 && box[1].y == 0));
    CHECK((box.back().x == 10 && box.back().y == 4));
}

TEST_CASE("the clearance is the distance of the two points that are nearest to each other")
{
    CHECK(clearance({{0, 0}, {10, 0}}, {{13, 4}, {0, 50}}) == doctest::Approx(5.0));
    CHECK(std::isinf(clearance({{0, 0}}, {})));
}

TEST_CASE("a shape goes to the corner of the room that the obstacles leave free, and stays inside")
{
    const std::vector<SvgPoint> shape = points_of_box({100, 100, 120, 110}, 5.0);
    const std::vector<SvgPoint> diagonal = points_of_line({0, 0}, {60, 100}, 5.0);
    const ClearPlace place = clear_place(shape, diagonal, {0, 0, 100, 100});
    CHECK(place.shift.x == doctest::Approx(-20.0)); // right edge: 120 - 20 = 100
    CHECK(place.shift.y == doctest::Approx(-100.0));
    std::vector<SvgPoint> moved = shape;
    for (SvgPoint& p : moved)
        p = {p.x + place.shift.x, p.y + place.shift.y};
    CHECK(place.clearance == doctest::Approx(clearance(moved, diagonal)));
}

TEST_CASE("a shape larger than the room stays at its left and top")
{
    const ClearPlace place = clear_place({{0, 0}, {200, 300}}, {{50, 50}}, {10, 20, 110, 120});
    CHECK(place.shift.x == 10.0);
    CHECK(place.shift.y == 20.0);
}

} // namespace clear_place_test
