#include "geometry/surface_hull.h"

#include "random_surfaces.h"

#include <cmath>
#include <doctest/doctest.h>
#include <vector>

namespace surface_hull_test {

using namespace multipath;

namespace {

/// Enough that corners are selected.
constexpr int many = 6000;

ConvexHull plain_hull(const std::vector<Surface>& surfaces)
{
    std::vector<Vec3> corners;
    for (const Surface& s : surfaces) {
        corners.insert(corners.end(), {s.origin, s.at(1.0, 0.0), s.at(0.0, 1.0)});
        if (s.shape == Shape::parallelogram)
            corners.push_back(s.at(1.0, 1.0));
    }
    return ConvexHull(corners);
}

/// Small surfaces at points that `place` chooses.
template <class Place>
std::vector<Surface> scattered(std::uint64_t key, const Place& place)
{
    Numbers numbers(key);
    std::vector<Surface> surfaces;
    for (int k = 0; k < many; ++k) {
        const Shape shape = k % 3 == 0 ? Shape::parallelogram : Shape::triangle;
        surfaces.push_back({shape, place(numbers), numbers.point(-0.05, 0.05), numbers.point(-0.05, 0.05)});
    }
    return surfaces;
}

} // namespace

TEST_CASE("the hull of thousands of surfaces is that of all their corners")
{
    for (std::uint64_t key = 1; key <= 5; ++key) {
        const auto in_cube = scattered(key, [](Numbers& numbers) { return numbers.point(-1, 1); });
        CHECK(hull_of(in_cube).area() == doctest::Approx(plain_hull(in_cube).area()).epsilon(1e-9));
        const auto on_sphere = scattered(key, [](Numbers& numbers) { return normalized(numbers.point(-1, 1)); });
        CHECK(hull_of(on_sphere).area() == doctest::Approx(plain_hull(on_sphere).area()).epsilon(1e-9));
        const auto far_away_rod = scattered(key, [](Numbers& numbers) {
            const Vec3 p = numbers.point(-1, 1);
            return Vec3{1000.0 + 100.0 * p.x, 0.1 * p.y - 50.0 * p.x, 0.1 * p.z};
        });
        CHECK(hull_of(far_away_rod).area() == doctest::Approx(plain_hull(far_away_rod).area()).epsilon(1e-7));
    }
}

TEST_CASE("the hull of thousands of surfaces in a room is the room")
{
    std::vector<Surface> surfaces = scattered(7, [](Numbers& numbers) { return numbers.point(-0.9, 0.9); });
    for (const double side : {-1.0, 1.0})
        surfaces.push_back({Shape::parallelogram, {-1, side, -2}, {2, 0, 0}, {0, 0, 4}});
    CHECK(hull_of(surfaces).area() == doctest::Approx(2.0 * (4 + 8 + 8)));
}

TEST_CASE("the hull of thousands of surfaces in one plane has two sides")
{
    std::vector<Surface> surfaces;
    for (int i = 0; i < 80; ++i)
        for (int j = 0; j < 60; ++j)
            surfaces.push_back({Shape::parallelogram, {0.1 * i, 0.1 * j, 0.1 * i}, {0.1, 0, 0.1}, {0, 0.1, 0}});
    CHECK(hull_of(surfaces).area() == doctest::Approx(2.0 * 8.0 * std::sqrt(2.0) * 6.0));
}

} // namespace surface_hull_test
