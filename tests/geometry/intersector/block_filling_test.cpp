#include "geometry/intersector/block_filling.h"

#include "geometry/intersector/surface_sizes.h"
#include "geometry/surface_pieces.h"

#include <cmath>
#include <doctest/doctest.h>
#include <numeric>

namespace block_filling_test {

using namespace multipath;

namespace {

/// The six sides of a box spanned by three edges.
SurfaceList box(Vec3 corner, Vec3 a, Vec3 b, Vec3 c)
{
    return {rectangle(corner, a, b),     rectangle(corner + c, a, b), rectangle(corner, b, c),
            rectangle(corner + a, b, c), rectangle(corner, c, a),     rectangle(corner + b, c, a)};
}

FramedRectangles grouped(const SurfaceList& surfaces)
{
    std::vector<std::uint32_t> all(surfaces.size());
    std::iota(all.begin(), all.end(), 0u);
    const Bounds bounds = bounds_of(surfaces);
    return group_by_frames(SurfaceTable(surfaces, share_planes(surfaces, order_by_descending_area(surfaces))), all,
                           FilterFrame(bounds));
}

} // namespace

TEST_CASE("two boxes with parallel edges have one frame, a turned one its own")
{
    SurfaceList surfaces = box({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3});
    for (const Surface& s : box({1, 1, 1}, {0, 0, -0.5}, {0.7, 0, 0}, {0, 0.2, 0}))
        surfaces.push_back(s);
    CHECK(grouped(surfaces).frames.size() == 1);
    for (const Surface& s : box({2, 1, 1}, {0.3, 0, 0.4}, {-0.4, 0, 0.3}, {0, 0.2, 0}))
        surfaces.push_back(s);
    const FramedRectangles result = grouped(surfaces);
    CHECK(result.frames.size() == 2);
    CHECK(result.rectangles.size() == 18);
    CHECK(result.others.empty());
    CHECK(result.frames[0].end[0] == 4); // of each of the two boxes, two sides across every axis
    CHECK(result.frames[0].end[2] == 12);
    CHECK(result.frames[1].end[2] == 18);
}

TEST_CASE("triangles and oblique parallelograms belong to no frame")
{
    const SurfaceList surfaces = {{Shape::triangle, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                  rectangle({0, 0, 1}, {1, 0, 0}, {0.2, 1, 0}),
                                  rectangle({0, 0, 2}, {1, 0, 0}, {0, 1, 0})};
    const FramedRectangles result = grouped(surfaces);
    CHECK(result.others == std::vector<std::uint32_t>{0, 1});
    CHECK(result.surfaces == std::vector<std::uint32_t>{2});
}

// What the filter will compute from a frame is what u and v of the rectangle are.
TEST_CASE("a point of a rectangle has the coordinates along the axes that the frame says")
{
    const SurfaceList surfaces = box({1, 2, 3}, {0.3, 0, 0.4}, {-0.8, 0, 0.6}, {0, 0.25, 0});
    const FramedRectangles result = grouped(surfaces);
    REQUIRE(result.frames.size() == 1);
    const Vec3 centre = Vec3{1, 2, 3} + 0.5 * Vec3{-0.5, 0.25, 1.0};
    const double radius = 0.5 * length(Vec3{0.3 + 0.8, 0.25, 0.4 + 0.6});
    std::size_t k = 0;
    for (std::size_t n = 0; n < result.rectangles.size(); ++n) {
        while (n >= result.frames[0].end[k])
            ++k;
        const auto along = [&](std::size_t axis, Vec3 p) {
            const float(&a)[3] = result.frames[0].axis[axis % 3];
            return dot(Vec3{a[0], a[1], a[2]}, (1.0 / radius) * (p - centre));
        };
        const FrameRectangle& r = result.rectangles[n];
        for (const double u : {0.0, 1.0})
            for (const double v : {0.0, 1.0}) {
                const Vec3 corner = surfaces[result.surfaces[n]].at(u, v);
                CHECK(along(k, corner) == doctest::Approx(r.offset).epsilon(1e-6));
                CHECK(std::abs(along(k + 1, corner) - r.centre_u) == doctest::Approx(r.half_u).epsilon(1e-5));
                CHECK(std::abs(along(k + 2, corner) - r.centre_v) == doctest::Approx(r.half_v).epsilon(1e-5));
            }
    }
}

} // namespace block_filling_test
