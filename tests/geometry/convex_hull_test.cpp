#include "geometry/convex_hull.h"

#include <cmath>
#include <doctest/doctest.h>

using namespace multipath;

TEST_CASE("the hull of a box, whatever lies inside or on its faces, is the box")
{
    std::vector<Vec3> points;
    for (int i = 0; i <= 4; ++i)
        for (int j = 0; j <= 4; ++j)
            for (int k = 0; k <= 4; ++k)
                points.push_back({1.0 * i / 4, 2.0 * j / 4, 3.0 * k / 4});
    CHECK(convex_hull_area(points) == doctest::Approx(2.0 * (2 + 6 + 3)));
}

// Points on a sphere: the hull has them all as corners and nearly the sphere's area, 4 pi (1 - O(1/n)).
TEST_CASE("the hull of a sphere is nearly the sphere")
{
    std::vector<Vec3> points;
    const double golden_angle = 2.399963229728653;
    for (int i = 0; i < 3000; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / 3000;
        const double r = std::sqrt(1 - z * z);
        points.push_back({100 + r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z});
    }
    const double sphere = 4 * 3.14159265358979323846;
    CHECK(convex_hull_area(points) < sphere);
    CHECK(convex_hull_area(points) > 0.996 * sphere);
}

TEST_CASE("an octahedron and a tetrahedron have their textbook areas")
{
    CHECK(convex_hull_area({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) ==
          doctest::Approx(4 * std::sqrt(3.0)));
    CHECK(convex_hull_area({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}) == doctest::Approx(8 * std::sqrt(3.0)));
}

TEST_CASE("a flat set counts both sides, a line or a point has no area")
{
    CHECK(convex_hull_area({{0, 0, 5}, {2, 0, 5}, {2, 3, 5}, {0, 3, 5}, {1, 1, 5}, {2, 1, 5}}) ==
          doctest::Approx(12.0));
    CHECK(convex_hull_area({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}) == doctest::Approx(0.0));
    CHECK(convex_hull_area({{1, 2, 3}}) == 0.0);
    CHECK(convex_hull_area({}) == 0.0);
}
