#include "image/smooth_shading.h"

#include "test_scenes.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace multipath;

namespace {

Rgb grey(double value)
{
    return {value, value, value};
}

/// One value per patch from the point at its centre.
template <class F>
std::vector<Rgb> at_centres(const Scene& scene, const F& value)
{
    std::vector<Rgb> values;
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        values.push_back(grey(value(scene.patch(patch).shape.centre())));
    return values;
}

double shown(const SmoothShading& shading, std::uint32_t surface, double u, double v, bool front = true)
{
    return shading.at({0.0, surface, u, v, front}).r;
}

/// A small lamp, because a scene must have one; far from everything else.
SceneBuilder with_lamp()
{
    SceneBuilder builder;
    return builder.rectangle({0.0, 50.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, builder.grey(0.5, 1.0));
}

} // namespace

TEST_CASE("a ramp runs through the seam between two rectangles of one wall")
{
    SceneBuilder builder = with_lamp();
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.rectangle({0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, paint);
    builder.rectangle({2.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, paint);
    const Scene scene = builder.scene(0.25);
    const std::vector<Rgb> values = at_centres(scene, [](Vec3 p) { return 1.0 + p.x + 2.0 * std::abs(p.y); });
    const SmoothShading shading(scene, values);
    CHECK(shown(shading, 1, 1.0, 0.5) == doctest::Approx(4.0).epsilon(1e-13)); // rounding
    CHECK(shown(shading, 2, 0.0, 0.5) == doctest::Approx(4.0).epsilon(1e-13));
    CHECK(shown(shading, 2, 0.9, 0.1) == doctest::Approx(1.0 + 2.9 + 0.2).epsilon(1e-13));
}

TEST_CASE("where two rectangles of one wall differ they meet at one value")
{
    SceneBuilder builder = with_lamp();
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.rectangle({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, paint);
    builder.rectangle({1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, paint);
    const Scene scene = builder.scene(0.25);
    const std::vector<Rgb> values = at_centres(scene, [](Vec3 p) { return p.x < 1.0 ? 1.0 : 3.0; });
    const SmoothShading shading(scene, values);
    for (const double v : {0.0, 0.4, 1.0}) {
        CHECK(shown(shading, 1, 1.0, v) == doctest::Approx(2.0));
        CHECK(shown(shading, 2, 0.0, v) == doctest::Approx(2.0));
    }
}

TEST_CASE("nothing leaks across an edge, to another material, or to a coincident face that looks the other way")
{
    SceneBuilder builder = with_lamp();
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    const std::uint32_t other_paint = builder.grey(0.5, 0.0);
    builder.rectangle({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, paint);        // dark
    builder.rectangle({1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, paint);        // around the corner
    builder.rectangle({-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, other_paint); // beside it
    builder.rectangle({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}, paint);        // behind it
    const Scene scene = builder.scene(0.25);
    std::vector<Rgb> values(scene.patch_count(), grey(100.0));
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        if (scene.surface_of(patch) == 1)
            values[patch] = grey(0.0);
    const SmoothShading shading(scene, values);
    for (const double u : {0.0, 0.1, 0.5, 1.0})
        for (const double v : {0.0, 0.5, 1.0}) {
            CHECK(shown(shading, 1, u, v) == 0.0);
            for (const std::uint32_t bright : {2u, 3u, 4u})
                CHECK(shown(shading, bright, u, v) == doctest::Approx(100.0));
        }
}

// Four triangles of a flat pyramid share its apex; each is one patch, so the apex is their mean and the outer corners
// of two neighbours are the mean of these two.
TEST_CASE("triangles of a curved skin share the values at their corners")
{
    SceneBuilder builder = with_lamp();
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    const Vec3 apex = {0.0, 0.1, 0.0};
    const Vec3 ring[4] = {{1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
    for (int i = 0; i < 4; ++i)
        builder.triangle(apex, ring[i], ring[(i + 1) % 4], paint);
    const Scene scene = builder.scene(10.0);
    REQUIRE(scene.patch_count() == 5);
    const std::vector<Rgb> values = {grey(7.0), grey(1.0), grey(2.0), grey(3.0), grey(6.0)};
    const SmoothShading shading(scene, values);
    for (std::uint32_t surface = 1; surface <= 4; ++surface)
        CHECK(shown(shading, surface, 0.0, 0.0) == doctest::Approx(3.0));
    CHECK(shown(shading, 1, 0.0, 1.0) == doctest::Approx(1.5));
    CHECK(shown(shading, 2, 1.0, 0.0) == doctest::Approx(1.5));
}

TEST_CASE("a source shows the plain values of its patches")
{
    const Scene scene = with_lamp().scene(0.5);
    REQUIRE(scene.patch_count() == 4);
    std::vector<Rgb> values(4, grey(1.0));
    values[scene.patch_at(0, 0.9, 0.9, true)] = grey(5.0);
    const SmoothShading shading(scene, values);
    CHECK(shown(shading, 0, 0.51, 0.51) == 5.0);
    CHECK(shown(shading, 0, 0.49, 0.51) == 1.0);
}

TEST_CASE("the two sides of a surface are shaded each from its own patches")
{
    SceneBuilder builder = with_lamp();
    builder.rectangle({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, builder.grey(0.5, 0.0));
    const Scene scene = builder.scene(0.5, true);
    std::vector<Rgb> values(scene.patch_count(), grey(2.0));
    for (std::uint32_t patch = scene.patch_count() / 2; patch < scene.patch_count(); ++patch)
        values[patch] = grey(4.0);
    const SmoothShading shading(scene, values);
    CHECK(shown(shading, 1, 0.3, 0.3, true) == doctest::Approx(2.0));
    CHECK(shown(shading, 1, 0.3, 0.3, false) == doctest::Approx(4.0));
}

TEST_CASE("the values at a patch's corners are those that the corners show")
{
    SceneBuilder builder = with_lamp();
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, paint).triangle({1, 0, 0}, {2, 0, 0}, {1, 1, 0}, paint);
    const Scene scene = builder.scene(0.3, true);
    std::vector<Rgb> values;
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        values.push_back(grey(patch * patch % 17));
    const SmoothShading shading(scene, values);
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
        const std::uint32_t surface = scene.surface_of(patch);
        const std::array<Rgb, 4> at_corners = shading.at_corners(patch);
        const CellCorners corners = scene.corners(patch);
        for (std::size_t k = 0; k < corners.count; ++k) {
            const double u = static_cast<double>(corners.points[k].i) / scene.tessellation(surface).cells_u;
            const double v = static_cast<double>(corners.points[k].j) / scene.tessellation(surface).cells_v;
            // The lamp is not interpolated: at its corners its patches differ.
            const double expected =
                surface == 0 ? values[patch].r : shown(shading, surface, u, v, scene.is_front(patch));
            REQUIRE(at_corners[k].r == doctest::Approx(expected).epsilon(1e-12)); // rounding of (u, v)
        }
    }
}
