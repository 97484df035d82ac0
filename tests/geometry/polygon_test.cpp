#include "geometry/polygon.h"

#include "base/elementary.h"

#include <cmath>
#include <doctest/doctest.h>

namespace polygon_test {

using namespace multipath;

namespace {

/// Irradiance below one corner of a rectangle a x b at height h that shines down: a textbook configuration factor.
double below_corner(double a, double b, double h)
{
    const double x = a / h;
    const double y = b / h;
    const double root_x = std::sqrt(1.0 + x * x);
    const double root_y = std::sqrt(1.0 + y * y);
    return (x / root_x * std::atan(y / root_x) + y / root_y * std::atan(x / root_y)) / (2.0 * pi);
}

Surface shining_down(Vec3 corner, double a, double b)
{
    return {Shape::parallelogram, corner, {a, 0, 0}, {0, 0, b}}; // x cross z = -y
}

constexpr Vec3 up = {0, 1, 0};

} // namespace

// Only rounding separates the two formulas.
TEST_CASE("the irradiance below the corner of a rectangle is the textbook's")
{
    for (const double h : {0.01, 0.5, 1.0, 30.0}) {
        CAPTURE(h);
        const Surface light = shining_down({1, h, 2}, 2.0, 3.0);
        CHECK(irradiance_from(polygon_of(light), {1, 0, 2}, up) ==
              doctest::Approx(below_corner(2, 3, h)).epsilon(1e-12));
        CHECK(irradiance_from(polygon_of(light), {1, 2 * h, 2}, -up) == 0.0); // seen from behind
    }
}

// A disc of radius R at height h gives R^2 / (R^2 + h^2); the square lies between two discs.
TEST_CASE("a rectangle that fills the sky gives an irradiance of 1")
{
    const Surface light = shining_down({-1e3, 1e-3, -1e3}, 2e3, 2e3);
    CHECK(irradiance_from(polygon_of(light), {0, 0, 0}, up) == doctest::Approx(1.0).epsilon(1e-11));
}

TEST_CASE("what lies below the horizon gives nothing")
{
    // A wall through the floor at x = 1 that faces the origin: its upper half is all that counts.
    const Surface wall = {Shape::parallelogram, {1, -1, -1}, {0, 0, 2}, {0, 2, 0}};
    const Surface upper_half = {Shape::parallelogram, {1, 0, -1}, {0, 0, 2}, {0, 1, 0}};
    REQUIRE(dot(wall.normal(), {-1, 0, 0}) == 1.0);
    const FlatPolygon part = part_above_horizon(wall, {0, 0, 0}, up);
    REQUIRE(part.size == 4);
    CHECK(irradiance_from(part, {0, 0, 0}, up) ==
          doctest::Approx(irradiance_from(polygon_of(upper_half), {0, 0, 0}, up)).epsilon(1e-14));

    CHECK(part_above_horizon(wall, {0, 1, 0}, up).empty());    // the plane through its upper edge
    CHECK(part_above_horizon(wall, {0, -1, 0}, up).size == 4); // ... and through its lower edge
    const Surface corner_down = {Shape::parallelogram, {1, -0.5, 0}, {0, 1, 1}, {0, 1, -1}};
    CHECK(part_above_horizon(corner_down, {0, 0, 0}, up).size == 5);
}

TEST_CASE("the distance from a polygon is that from its inside, an edge or a corner")
{
    const FlatPolygon square = polygon_of(shining_down({0, 0, 0}, 1.0, 1.0));
    CHECK(distance({0.3, 2, 0.6}, square) == doctest::Approx(2.0));
    CHECK(distance({0.3, 0, -4}, square) == doctest::Approx(4.0));
    CHECK(distance({4, 12, -3}, square) == doctest::Approx(std::sqrt(9.0 + 144.0 + 9.0)));
}

} // namespace polygon_test
