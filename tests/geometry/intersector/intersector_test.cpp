#include "geometry/intersector/intersector.h"

#include "geometry/intersector/shared_planes.h"
#include "geometry/intersector/surface_block.h"
#include "geometry/intersector/surface_sizes.h"
#include "geometry/random_surfaces.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace intersector_test {

using namespace multipath;

namespace {

/// Brute force by another formula (Cramer's rule on o + t d = p + u a + v b), in long double.
std::vector<Hit> hits_by_cramer(const SurfaceList& surfaces, const Line& line)
{
    using Real = long double;
    struct Wide
    {
        Real x, y, z;
    };
    const auto wide = [](Vec3 v) { return Wide{v.x, v.y, v.z}; };
    const auto determinant = [](Wide a, Wide b, Wide c) {
        return a.x * (b.y * c.z - b.z * c.y) - a.y * (b.x * c.z - b.z * c.x) + a.z * (b.x * c.y - b.y * c.x);
    };
    std::vector<Hit> hits;
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        const Wide a = wide(surfaces[s].edge_u);
        const Wide b = wide(surfaces[s].edge_v);
        const Wide d = wide(-line.direction);
        const Wide r = {Real(line.origin.x) - surfaces[s].origin.x, Real(line.origin.y) - surfaces[s].origin.y,
                        Real(line.origin.z) - surfaces[s].origin.z};
        const Real whole = determinant(a, b, d);
        const Real u = determinant(r, b, d) / whole;
        const Real v = determinant(a, r, d) / whole;
        const Real t = determinant(a, b, r) / whole;
        const bool inside = u >= 0 && v >= 0 && (surfaces[s].shape == Shape::triangle ? u + v <= 1 : u <= 1 && v <= 1);
        if (inside && t >= 0 && t <= line.t_max)
            hits.push_back({double(t), s, double(u), double(v), whole > 0});
    }
    std::sort(hits.begin(), hits.end(), [](const Hit& x, const Hit& y) { return x.t < y.t; });
    return hits;
}

} // namespace

// 20 surfaces are all filtered, 400 found through the hierarchy.
TEST_CASE("all hits and the closest hit are those of brute force")
{
    for (const std::size_t count : {1u, 20u, 400u}) {
        const SurfaceList surfaces = scattered_surfaces(count, count > 100 ? 0.2 : 0.5, count);
        const Intersector intersector(surfaces);
        Numbers numbers(7);
        std::vector<Hit> hits;
        for (int n = 0; n < 20000; ++n) {
            const Line line = chord(numbers.point(-0.5, 1.5), numbers.point(-0.5, 1.5));
            const std::vector<Hit> expected = hits_by_cramer(surfaces, line);
            intersector.all_hits(line, hits);
            REQUIRE(hits.size() == expected.size());
            for (std::size_t i = 0; i < hits.size(); ++i) {
                REQUIRE(hits[i].surface == expected[i].surface);
                REQUIRE(hits[i].front == expected[i].front);
                REQUIRE(hits[i].t == doctest::Approx(expected[i].t).epsilon(1e-9));
                REQUIRE(std::abs(hits[i].u - expected[i].u) < 1e-9); // oblique lines lose some digits
                REQUIRE(std::abs(hits[i].v - expected[i].v) < 1e-9);
            }
            const std::optional<Hit> closest = intersector.closest_hit(line);
            REQUIRE(closest.has_value() == !expected.empty());
            if (closest)
                REQUIRE(closest->surface == expected[0].surface);
        }
    }
}

// A line from outside to outside goes into a convex solid as often as it comes out, and never twice in a row.
TEST_CASE("closed solids are entered and left in turn")
{
    SurfaceList surfaces;
    Numbers numbers(3);
    for (int box = 0; box < 170; ++box) {
        const Vec3 low = numbers.point(0, 1);
        const Vec3 d = {0.1, 0.2, 0.15};
        const Vec3 x = {d.x, 0, 0};
        const Vec3 y = {0, d.y, 0};
        const Vec3 z = {0, 0, d.z};
        for (const Surface& face : {Surface{Shape::parallelogram, low, x, z},
                                    {Shape::parallelogram, low + y, z, x},
                                    {Shape::parallelogram, low, z, y},
                                    {Shape::parallelogram, low + x, y, z},
                                    {Shape::parallelogram, low, y, x},
                                    {Shape::parallelogram, low + z, x, y}})
            surfaces.push_back(face);
    }
    const Intersector intersector(surfaces);
    std::vector<Hit> hits;
    std::size_t met = 0;
    for (int n = 0; n < 20000; ++n) { // from below all boxes to above all of them
        intersector.all_hits(chord({numbers.within(-1, 2), -1, numbers.within(-1, 2)},
                                   {numbers.within(-1, 2), 3, numbers.within(-1, 2)}),
                             hits);
        met += hits.size();
        std::vector<int> inside(170, 0);
        for (const Hit& hit : hits) {
            inside[hit.surface / 6] += hit.front ? 1 : -1;
            REQUIRE((inside[hit.surface / 6] == 0 || inside[hit.surface / 6] == 1));
        }
        REQUIRE(std::count(inside.begin(), inside.end(), 0) == 170);
    }
    CHECK(met > 20000);
}

TEST_CASE("coplanar surfaces are met at exactly the same t, whichever way they face")
{
    // Two faces of a sheet and a neighbour in its plane, turned in space; the second lists its corners from elsewhere,
    // so that its plane comes out of other roundings.
    const Vec3 a = normalized({1, 2, 3});
    const Vec3 b = normalized(cross(a, {0.3, -1, 0.2}));
    const Vec3 corner = {0.1, 0.7, 0.3};
    const SurfaceList surfaces = {{Shape::parallelogram, corner, a, b},
                                  {Shape::parallelogram, corner + a + b, -b, -a},
                                  {Shape::triangle, corner + 0.3 * a, 0.5 * b, -0.9 * a},
                                  {Shape::parallelogram, corner + Vec3{0, 1, 0}, a, b}};
    CHECK(share_planes(surfaces, order_by_descending_area(surfaces)).plane_number ==
          std::vector<std::uint32_t>{0, 0, 0, 1});
    const Intersector intersector(surfaces);
    Numbers numbers(5);
    std::vector<Hit> hits;
    int met_both = 0;
    for (int n = 0; n < 5000; ++n) {
        intersector.all_hits(chord(numbers.point(-1, 2), numbers.point(-1, 2)), hits);
        for (std::size_t i = 1; i < hits.size(); ++i)
            if (hits[i - 1].surface + hits[i].surface == 1) { // 0 and 1 in either order
                ++met_both;
                REQUIRE(hits[i - 1].t == hits[i].t);
                REQUIRE(hits[i - 1].front != hits[i].front);
            }
    }
    CHECK(met_both > 300);
}

TEST_CASE("lines in the plane of a surface, and lines of no length, meet nothing")
{
    const Intersector intersector({{Shape::parallelogram, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}}});
    std::vector<Hit> hits;
    intersector.all_hits(chord({-1, 0, 0.5}, {2, 0, 0.5}), hits);
    CHECK(hits.empty());
    intersector.all_hits(chord({0.5, 0, 0.5}, {0.5, 0, 0.5}), hits);
    CHECK(hits.empty());
    CHECK(!intersector.closest_hit({{0.5, 1, 0.5}, {0, 1, 0}}));
}

// A lamp drawn on the ceiling, a rug on the floor: of two faces that look the same way from one plane the smaller is on
// top.
TEST_CASE("of coincident faces the smaller covers the larger, seen from either end of a line")
{
    for (const bool lamp_first : {true, false}) {
        const Surface ceiling = {Shape::parallelogram, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
        const Surface lamp = {Shape::parallelogram, {0.4, 1, 0.4}, {0.2, 0, 0}, {0, 0, 0.2}};
        const SurfaceList surfaces = lamp_first ? SurfaceList{lamp, ceiling} : SurfaceList{ceiling, lamp};
        const std::uint32_t lamp_number = lamp_first ? 0 : 1;
        const Intersector intersector(surfaces);
        std::vector<Hit> hits;
        intersector.all_hits(chord({0.5, 0, 0.5}, {0.51, 2, 0.5}), hits); // up: arrives
        REQUIRE(hits.size() == 2);
        CHECK(hits[0].surface == lamp_number);
        intersector.all_hits(chord({0.5, 2, 0.5}, {0.51, 0, 0.5}), hits); // down: departs, the lamp last
        REQUIRE(hits.size() == 2);
        CHECK(hits[1].surface == lamp_number);
        CHECK(intersector.closest_hit(chord({0.5, 2, 0.5}, {0.51, 0, 0.5}))->surface == 1 - lamp_number);
        CHECK(intersector.closest_hit(chord({0.5, 0, 0.5}, {0.51, 2, 0.5}))->surface == lamp_number);
        CHECK(!intersector.closest_hit_from(lamp_number, {{0.5, 1, 0.5}, {0, -1, 0}}));
        CHECK(intersector.closest_hit_from(1 - lamp_number, {{0.5, 1, 0.5}, {0, -1, 0}})->surface == lamp_number);
    }
}

// A sheet whose two sides are almost coplanar_distance apart, one side of more pieces than are all filtered: found
// through the hierarchy as if it were one plane, also by lines so flat that they cross it well beside where they meet
// the piece.
TEST_CASE("the hierarchy does not lose faces that lie beside their shared plane")
{
    constexpr std::uint32_t count = FlatSurfaces::most;
    constexpr double width = 1.0 / count;
    constexpr double gap = 1e-5;                                                      // of a diagonal of 2.4
    SurfaceList surfaces = {{Shape::parallelogram, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}}}; // looks up
    for (std::uint32_t i = 0; i < count; ++i)
        surfaces.push_back({Shape::parallelogram, {i * width, gap, 0}, {width, 0, 0}, {0, 0, 1}}); // look down
    surfaces.push_back({Shape::parallelogram, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}});
    surfaces.push_back({Shape::parallelogram, {0, -1, 0}, {0, 0, 1}, {1, 0, 0}});
    const Intersector intersector(surfaces);
    Numbers numbers(11);
    std::vector<Hit> hits;
    for (int n = 0; n < 2000; ++n) {
        const double x = numbers.within(0.41, 0.59);
        intersector.all_hits(chord({x - 0.4, 4e-4, 0.5}, {x + 0.4, -4e-4, 0.5}), hits);
        REQUIRE(hits.size() >= 2);
        REQUIRE(hits[0].t == hits[1].t);
        const auto [upper, lower] = std::minmax(hits[0].surface, hits[1].surface);
        REQUIRE(upper == 0);
        const std::optional<Hit> below = intersector.closest_hit_from(lower, {{x, gap, 0.5}, {0, -1, 0}});
        REQUIRE(below->surface == count + 2); // not the upper side
    }
}

} // namespace intersector_test
