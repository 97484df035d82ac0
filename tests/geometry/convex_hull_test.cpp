#include "base/elementary.h"
#include "geometry/convex_hull.h"
#include "geometry/random_surfaces.h"

#include <cmath>
#include <doctest/doctest.h>
#include <vector>

namespace convex_hull_test {

using namespace multipath;

TEST_CASE("the hull of a box, whatever lies inside or on its faces, is the box")
{
    LargeVector<Vec3> points;
    for (int i = 0; i <= 4; ++i)
        for (int j = 0; j <= 4; ++j)
            for (int k = 0; k <= 4; ++k)
                points.push_back({1.0 * i / 4, 2.0 * j / 4, 3.0 * k / 4});
    CHECK(ConvexHull(points).area() == doctest::Approx(2.0 * (2 + 6 + 3)));
}

// Points on a sphere: the hull has them all as corners and nearly the sphere's area, 4 pi (1 - O(1/n)).
TEST_CASE("the hull of a sphere is nearly the sphere")
{
    LargeVector<Vec3> points;
    const double golden_angle = 2.399963229728653;
    for (int i = 0; i < 3000; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / 3000;
        const double r = std::sqrt(1 - z * z);
        points.push_back({100 + r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z});
    }
    const double sphere = 4 * pi;
    CHECK(ConvexHull(points).area() < sphere);
    CHECK(ConvexHull(points).area() > 0.996 * sphere);
}

TEST_CASE("an octahedron and a tetrahedron have their textbook areas")
{
    CHECK(ConvexHull({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}).area() ==
          doctest::Approx(4 * std::sqrt(3.0)));
    CHECK(ConvexHull({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}).area() == doctest::Approx(8 * std::sqrt(3.0)));
}

TEST_CASE("a flat set counts both sides, a line or a point has no area")
{
    CHECK(ConvexHull({{0, 0, 5}, {2, 0, 5}, {2, 3, 5}, {0, 3, 5}, {1, 1, 5}, {2, 1, 5}}).area() ==
          doctest::Approx(12.0));
    CHECK(ConvexHull({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}).area() == doctest::Approx(0.0));
    CHECK(ConvexHull({{1, 2, 3}}).area() == 0.0);
    CHECK(ConvexHull({}).area() == 0.0);
}

// Flattened to a ten-thousandth and less, points have the hull of their outline, seen from both sides, and a rim: less
// than the thickness times the circumference. In space the set lies askew, so that coordinates round.
TEST_CASE("the hull of a set that is all but flat is that of its outline, twice")
{
    const Vec3 x = normalized({1, 2, -0.5});
    const Vec3 y = normalized(cross(x, {0.3, -1, 2}));
    const Vec3 z = cross(x, y);
    for (const double thickness : {1e-3, 1e-4, 1e-5, 1e-6, 3e-7}) {
        CAPTURE(thickness);
        for (std::uint64_t key = 0; key < 40; ++key) {
            Numbers numbers(key);
            LargeVector<Vec3> flat, thick;
            for (int i = 0; i < 500; ++i) {
                const Vec3 p = numbers.point(-1, 1);
                flat.push_back({p.x, p.y, 0});
                thick.push_back(p.x * x + p.y * y + thickness * p.z * z);
            }
            const double outline = ConvexHull(flat).area();
            CHECK(ConvexHull(thick).area() > (1.0 - 1e-6) * outline);
            CHECK(ConvexHull(thick).area() < outline + 8.0 * 2.0 * thickness);
        }
    }
}

// The regular polygon of n corners in the unit circle has the area n / 2 sin(2 pi / n). As a plane figure and as the
// rims of a drum and of a cone; a hull found in a time that grows with n^2 would take minutes here.
TEST_CASE("the hull of a hundred thousand points of a circle is their polygon")
{
    constexpr int n = 100000;
    const Vec3 x = normalized({1, 2, -0.5});
    const Vec3 y = normalized(cross(x, {0.3, -1, 2}));
    const Vec3 z = cross(x, y);
    LargeVector<Vec3> circle, drum;
    for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * pi * ((i * 37) % n) / n;
        const Vec3 p = Vec3{5, 6, 7} + std::cos(angle) * x + std::sin(angle) * y;
        circle.push_back(p);
        drum.push_back(p);
        drum.push_back(p + 2.0 * z);
    }
    const double polygon = 0.5 * n * std::sin(2.0 * pi / n);
    CHECK(ConvexHull(circle).area() == doctest::Approx(2.0 * polygon).epsilon(1e-9));
    CHECK(ConvexHull(drum).area() == doctest::Approx(2.0 * polygon + 2.0 * 2.0 * pi).epsilon(1e-6));
    LargeVector<Vec3> cone = circle;
    cone.push_back(Vec3{5, 6, 7} + z);
    CHECK(ConvexHull(cone).area() == doctest::Approx(polygon + pi * std::sqrt(2.0)).epsilon(1e-6));
}

TEST_CASE("points beyond one side of a hull lie beside it, points around an edge are not found to")
{
    const ConvexHull cube({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}});
    CHECK(cube.is_separated_from({{2, 0, 0}, {1.1, 5, 0}, {1.1, -5, 7}}, 0.0));
    CHECK(!cube.is_separated_from({{2, 0, 0}, {0.9, 0.5, 0.5}}, 0.0));
    CHECK(cube.is_separated_from({{2, 0, 0}, {0.9, 0.5, 0.5}}, 0.11));
    CHECK(!cube.is_separated_from({{1.1, 0.5, 0.5}, {0.5, 1.1, 0.5}}, 0.0));
    CHECK(!ConvexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).is_separated_from({{0, 0, 1}}, 0.0)); // flat
}

// A line meets the cube's hull exactly when it meets one of the cube's six faces.
TEST_CASE("lines meet the hull of a box when they meet its faces")
{
    const ConvexHull hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}});
    int met = 0;
    for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 40; ++j) {
            const Line line = chord({-1.03 + 0.077 * i, -1, 0.31}, {0.2, -1.01 + 0.079 * j, 2});
            bool expected = false;
            for (int axis = 0; axis < 3; ++axis)
                for (int side = 0; side < 2; ++side) {
                    const auto part = [&](Vec3 v, int a) { return a == 0 ? v.x : a == 1 ? v.y : v.z; };
                    const double d = part(line.direction, axis);
                    const Vec3 p = line.at((side - part(line.origin, axis)) / d);
                    const double a = part(p, (axis + 1) % 3);
                    const double b = part(p, (axis + 2) % 3);
                    expected = expected || (d != 0.0 && a >= 0 && a <= 1 && b >= 0 && b <= 1);
                }
            met += expected ? 1 : 0;
            CHECK(hull.meets(line) == expected);
        }
    CHECK(met > 100);
    CHECK(met < 1400);
}

namespace {

/// Small surfaces at points that `place` chooses.
template <class Place>
SurfaceList scattered(std::uint64_t key, const Place& place)
{
    Numbers numbers(key);
    SurfaceList surfaces;
    for (int k = 0; k < 6000; ++k) {
        const Shape shape = k % 3 == 0 ? Shape::parallelogram : Shape::triangle;
        surfaces.push_back({shape, place(numbers), numbers.point(-0.05, 0.05), numbers.point(-0.05, 0.05)});
    }
    return surfaces;
}

} // namespace

TEST_CASE("the hull of thousands of surfaces in a room is the room")
{
    SurfaceList surfaces = scattered(7, [](Numbers& numbers) { return numbers.point(-0.9, 0.9); });
    for (const double side : {-1.0, 1.0})
        surfaces.push_back({Shape::parallelogram, {-1, side, -2}, {2, 0, 0}, {0, 0, 4}});
    CHECK(hull_of(surfaces).area() == doctest::Approx(2.0 * (4 + 8 + 8)));
}

TEST_CASE("the hull of thousands of surfaces in one plane has two sides")
{
    SurfaceList surfaces;
    for (int i = 0; i < 80; ++i)
        for (int j = 0; j < 60; ++j)
            surfaces.push_back({Shape::parallelogram, {0.1 * i, 0.1 * j, 0.1 * i}, {0.1, 0, 0.1}, {0, 0.1, 0}});
    CHECK(hull_of(surfaces).area() == doctest::Approx(2.0 * 8.0 * std::sqrt(2.0) * 6.0));
}

} // namespace convex_hull_test
