#include "image/shading/smooth_shading.h"

#include "image/shading/visible_patches.h"
#include "scene/daylight.h"
#include "scene/texture/texture.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace smooth_shading_test {

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
    const SmoothShading shading(scene, values, 1);
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
    const SmoothShading shading(scene, values, 1);
    for (const double v : {0.0, 0.4, 1.0}) {
        CHECK(shown(shading, 1, 1.0, v) == doctest::Approx(2.0));
        CHECK(shown(shading, 2, 0.0, v) == doctest::Approx(2.0));
    }
}

// The corners are looked up in cells of a millionth of the scene's diagonal, here 5 m: x = 1 m is a multiple of them.
TEST_CASE("corners that differ by rounding meet at one value, also at round coordinates")
{
    SceneBuilder builder;
    builder.rectangle({0.0, 3.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, builder.grey(0.5, 1.0));
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.rectangle({0.0, 0.0, 0.0}, {1.0 - 1e-14, 0.0, 0.0}, {0.0, 1.0, 0.0}, paint);
    builder.rectangle({1.0 + 1e-14, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, paint);
    const Scene scene = builder.scene(0.25);
    REQUIRE(scene.bounds().diagonal() == doctest::Approx(5.0).epsilon(1e-12));
    const SmoothShading shading(scene, at_centres(scene, [](Vec3 p) { return p.x < 1.0 ? 1.0 : 3.0; }), 1);
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
    builder.rectangle({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, paint);        // behind the others
    builder.rectangle({-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}, other_paint);
    builder.room({-5.0, -5.0, -5.0}, {5.0, 60.0, 5.0}, paint);
    const Scene scene = builder.scene(0.25);
    std::vector<Rgb> values(scene.patch_count(), grey(100.0));
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        if (scene.surface_of(patch) == 1)
            values[patch] = grey(0.0);
    const SmoothShading shading(scene, values, 1);
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
    const SmoothShading shading(scene, values, 1);
    for (std::uint32_t surface = 1; surface <= 4; ++surface)
        CHECK(shown(shading, surface, 0.0, 0.0) == doctest::Approx(3.0));
    CHECK(shown(shading, 1, 0.0, 1.0) == doctest::Approx(1.5));
    CHECK(shown(shading, 2, 1.0, 0.0) == doctest::Approx(1.5));
}

// What it reflects varies beside a frame as on any wall.
TEST_CASE("a source is shaded like everything else")
{
    const Scene scene = with_lamp().scene(0.1);
    const SmoothShading shading(scene, at_centres(scene, [](Vec3 p) { return 5.0 + p.x - 2.0 * p.z; }), 1);
    CHECK(shown(shading, 0, 0.53, 0.21) == doctest::Approx(5.0 + 0.53 - 2.0 * 0.21));
}

TEST_CASE("the two sides of a surface are shaded each from its own patches")
{
    SceneBuilder builder = with_lamp();
    builder.rectangle({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, builder.grey(0.5, 0.0));
    const Scene scene = builder.scene(0.5, true);
    std::vector<Rgb> values(scene.patch_count(), grey(2.0));
    for (std::uint32_t patch = scene.patch_count() / 2; patch < scene.patch_count(); ++patch)
        values[patch] = grey(4.0);
    const SmoothShading shading(scene, values, 1);
    CHECK(shown(shading, 1, 0.3, 0.3, true) == doctest::Approx(2.0));
    CHECK(shown(shading, 1, 0.3, 0.3, false) == doctest::Approx(4.0));
}

// A patch for each pixel of the texture. Where it is black in a channel, the grey light shows in the others.
TEST_CASE("without its texture a surface in grey light has one colour, whichever colours its pixels lack")
{
    SceneBuilder builder = with_lamp();
    builder.rectangle({0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, builder.material({}, {}));
    SceneFile file = builder.file();
    file.textures = {std::make_shared<const Texture>(
        "colours.ppm", "P3 3 2 255\n200 0 0 0 150 90 255 255 255\n0 0 70 120 0 230 30 60 0\n", false)};
    Material& painted = file.materials[file.material[1]];
    painted.texture = 0;
    painted.texture_scale = {0.9, 0.7, 0.5};
    painted.reflectance = painted.texture_scale * file.textures[0]->mean();
    file.texture_frames = {{}, {{0, 0}, {1, 0}, {0, 1}, true}};
    const Scene scene(file, 1.0);
    REQUIRE(scene.patch_count() == 7);
    std::vector<Rgb> radiosity;
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        radiosity.push_back(scene.emittance(patch) + 3.0 * scene.reflectance(patch));
    const std::vector<Rgb> plain = without_texture(scene, radiosity);
    for (std::uint32_t patch = 1; patch < scene.patch_count(); ++patch) {
        CAPTURE(patch);
        CHECK(plain[patch].r == doctest::Approx(3.0 * painted.reflectance.r).epsilon(1e-12));
        CHECK(plain[patch].g == doctest::Approx(3.0 * painted.reflectance.g).epsilon(1e-12));
        CHECK(plain[patch].b == doctest::Approx(3.0 * painted.reflectance.b).epsilon(1e-12));
    }
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
    const SmoothShading shading(scene, values, 1);
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
        const std::uint32_t surface = scene.surface_of(patch);
        const std::array<Rgb, 4> at_corners = shading.at_corners(patch);
        const CellCorners corners = scene.corners(patch);
        for (std::size_t k = 0; k < corners.count; ++k) {
            const double u = static_cast<double>(corners.points[k].i) / scene.tessellation(surface).cells_u;
            const double v = static_cast<double>(corners.points[k].j) / scene.tessellation(surface).cells_v;
            const double expected = shown(shading, surface, u, v, scene.is_front(patch));
            REQUIRE(at_corners[k].r == doctest::Approx(expected).epsilon(1e-12)); // rounding of (u, v)
        }
    }
}

TEST_CASE("a linear ramp over a parallelogram is reproduced everywhere, its border included")
{
    for (const double patch_size : {0.5, 0.3}) {
        SceneBuilder builder = with_lamp();
        builder.rectangle({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, builder.grey(0.5, 0.0));
        const Scene scene = builder.scene(patch_size);
        const std::vector<Rgb> values = at_centres(scene, [](Vec3 p) { return 1.0 + 2.0 * p.x + 3.0 * p.y; });
        const SmoothShading shading(scene, values, 1);
        for (const double u : {0.0, 0.03, 0.5, 0.77, 1.0})
            for (const double v : {0.0, 0.2, 0.51, 1.0})
                CHECK(shown(shading, 1, u, v) == doctest::Approx(1.0 + 2.0 * u + 3.0 * v).epsilon(1e-13)); // rounding
    }
}

TEST_CASE("a linear ramp over a triangle is reproduced")
{
    SceneBuilder builder = with_lamp();
    builder.triangle({0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {0.0, 3.0, 0.0}, builder.grey(0.5, 0.0));
    const Scene scene = builder.scene(1.5);
    REQUIRE(scene.tessellation(1).cells_u == 3);
    const std::vector<Rgb> values = at_centres(scene, [](Vec3 p) { return 1.0 + 2.0 * p.x + 3.0 * p.y; });
    const SmoothShading shading(scene, values, 1);
    for (const double u : {0.0, 0.1, 1.0 / 3.0, 0.6, 0.9})
        for (const double v : {0.0, 0.05, 1.0 / 3.0})
            if (u + v <= 1.0)
                CHECK(shown(shading, 1, u, v) == doctest::Approx(1.0 + 6.0 * u + 9.0 * v).epsilon(1e-12)); // rounding
}

TEST_CASE("a ramp over patches of different sizes is reproduced")
{
    for (const bool triangle : {false, true}) {
        SceneBuilder builder = with_lamp();
        const std::uint32_t paint = builder.grey(0.5, 0.0);
        if (triangle)
            builder.triangle({0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {0.0, 4.0, 0.0}, paint);
        else
            builder.rectangle({0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {0.0, 4.0, 0.0}, paint);
        const Scene scene = unevenly_refined(builder.scene(triangle ? 1.5 : 1.0));
        REQUIRE(scene.patch_count() > 40);
        const std::vector<Rgb> values = at_centres(scene, [](Vec3 p) { return 1.0 + 2.0 * p.x + 3.0 * p.y; });
        const SmoothShading shading(scene, values, 1);
        for (double u = 0.0; u <= 1.0; u += 0.03)
            for (double v = 0.0; v <= (triangle ? 1.0 - u : 1.0); v += 0.03)
                CHECK(shown(shading, 1, u, v) == doctest::Approx(1.0 + 8.0 * u + 12.0 * v).epsilon(1e-12)); // rounding
    }
}

// On both sides of the edges, whatever the values.
TEST_CASE("patches of different sizes meet without a step")
{
    SceneBuilder builder = with_lamp();
    builder.rectangle({0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {0.0, 4.0, 0.0}, builder.grey(0.5, 0.0));
    const Scene scene = unevenly_refined(builder.scene(1.0));
    const std::vector<Rgb> values =
        at_centres(scene, [](Vec3 p) { return 5.0 + std::sin(7.0 * p.x + 3.0 * p.y * p.y); });
    const SmoothShading shading(scene, values, 1);
    for (std::uint32_t patch = scene.first_patch(1); patch < scene.patch_count(); ++patch) {
        const Surface shape = scene.patch(patch).shape;
        for (const double along : {0.1, 0.3, 0.5, 0.8}) {
            const Vec3 place = 0.25 * shape.at(along, 0.0);
            constexpr double beside = 1e-9;
            if (place.y > beside)
                CHECK(shown(shading, 1, place.x, place.y - beside) ==
                      doctest::Approx(shown(shading, 1, place.x, place.y + beside)).epsilon(1e-6));
        }
    }
}

// Bright against dark in the middle: straight extrapolation would leave the range of the values.
TEST_CASE("a step does not overshoot and nothing becomes negative")
{
    SceneBuilder builder = with_lamp();
    builder.rectangle({0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, builder.grey(0.5, 0.0));
    const Scene scene = builder.scene(1.0);
    std::vector<Rgb> values(scene.patch_count(), grey(1.0));
    values[scene.patch_at(1, 0.1, 0.5, true)] = {0.0, 0.1, 1.0};
    values[scene.patch_at(1, 0.9, 0.5, true)] = {0.0, 5.0, 1.0};
    const SmoothShading shading(scene, values, 1);
    for (double u = 0.0; u <= 1.0; u += 0.125) {
        const Rgb value = shading.at({0.0, 1, u, 0.5, true});
        CHECK(value.r >= 0.0);
        CHECK(value.r <= 1.0);
        CHECK(value.g >= 0.0);
        CHECK(value.b == doctest::Approx(1.0));
    }
}

// By hand: from the border inward 5, 1, 0.9 the slope is 4 half a step inside, and that of the next patch 0.2, with
// which it does not go below 0.9 at its edge: so the border patch has 0.4, and the corner is 5 + 0.4 / 2. For 2, 1, 2
// the next patch is level, and so is that at the border. For 2, 3, 5, 7 the slopes are 1 half a step inside and 1.5 at
// the next patch: 0.5 at the border, as of a quadratic function.
TEST_CASE("slopes at a border continue those inside, and are none where they disagree")
{
    SceneBuilder builder = with_lamp();
    builder.rectangle({0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, builder.grey(0.5, 0.0));
    const Scene scene = builder.scene(1.0);
    std::vector<Rgb> values(scene.patch_count());
    values[scene.patch_at(1, 0.1, 0.5, true)] = {5.0, 2.0, 2.0};
    values[scene.patch_at(1, 0.3, 0.5, true)] = {1.0, 1.0, 3.0};
    values[scene.patch_at(1, 0.6, 0.5, true)] = {0.9, 2.0, 5.0};
    values[scene.patch_at(1, 0.9, 0.5, true)] = {0.8, 2.0, 7.0};
    const SmoothShading shading(scene, values, 1);
    CHECK(shading.at({0.0, 1, 0.0, 0.0, true}).r == doctest::Approx(5.2));
    CHECK(shading.at({0.0, 1, 0.0, 0.0, true}).g == doctest::Approx(2.0));
    CHECK(shading.at({0.0, 1, 0.0, 0.0, true}).b == doctest::Approx(1.75));
}

// x^2: linear functions of slope 2 x meet at the corners, and the slope changes by 2 from patch to patch towards two of
// four neighbours; at the border towards one of three, and counts 40 times.
TEST_CASE("the interpolation error of a quadratic function is its bend alone")
{
    SceneBuilder builder = with_lamp();
    builder.rectangle({0.0, 0.0, 0.0}, {8.0, 0.0, 0.0}, {0.0, 8.0, 0.0}, builder.grey(0.5, 0.0));
    const Scene scene = builder.scene(1.0);
    const auto square = [](Vec3 p) { return (p.x + 0.5) * (p.x + 0.5); };
    const std::vector<double> errors = interpolation_errors(scene, at_centres(scene, square), 1);
    CHECK(errors[scene.patch_at(1, 0.51, 0.51, true)] == doctest::Approx(2.0 * 2.0 / 2.0 / 40.0));
    CHECK(errors[scene.patch_at(1, 0.51, 0.01, true)] == doctest::Approx(2.0 * 2.0 * 2.0 / 3.0));
}

// A floor on which something stands.

namespace {

/// Floor of two rectangles that meet at x = 1, or of one; lit up to x = 1 and dark beyond.
SceneBuilder lit_and_dark_floor(bool one_surface)
{
    SceneBuilder builder = with_lamp();
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.rectangle({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {one_surface ? 2.0 : 1.0, 0.0, 0.0}, paint);
    if (!one_surface)
        builder.rectangle({1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, paint);
    return builder;
}

std::vector<Rgb> lit_and_dark(const Scene& scene)
{
    return at_centres(scene, [](Vec3 p) { return p.x < 1.0 ? 8.0 : 0.0; });
}

/// The value on the floor at (x, 0, z).
double on_floor(const SmoothShading& shading, bool one_surface, double x, double z)
{
    if (one_surface)
        return shown(shading, 1, z, x / 2.0);
    return x < 1.0 ? shown(shading, 1, z, x) : shown(shading, 2, z, x - 1.0);
}

} // namespace

TEST_CASE("no light leaks below a wall that stands on the floor, be it a sheet or a box")
{
    for (const bool one_surface : {false, true})
        for (const double thickness : {0.0, 0.06}) {
            SceneBuilder builder = lit_and_dark_floor(one_surface);
            builder.box({1.0 - 0.5 * thickness, 0.0, 0.0}, {1.0 + 0.5 * thickness + 1e-9, 1.0, 1.0},
                        builder.grey(0.5, 0.0));
            const Scene scene = builder.scene(0.25);
            const std::vector<Rgb> values = lit_and_dark(scene);
            const SmoothShading shading(scene, values, 1);
            for (const double z : {0.0, 0.3, 1.0}) {
                CHECK(on_floor(shading, one_surface, 0.96, z) >= 8.0); // more on what the box leaves of the patch
                CHECK(on_floor(shading, one_surface, 1.04, z) == 0.0);
            }
        }
}

TEST_CASE("without the wall the floor is smooth, and the leg of a table does not part it")
{
    for (const bool one_surface : {false, true})
        for (const bool leg : {false, true}) {
            SceneBuilder builder = lit_and_dark_floor(one_surface);
            if (leg)
                builder.box({0.97, 0.0, 0.47}, {1.03, 0.7, 0.53}, builder.grey(0.5, 0.0));
            const Scene scene = builder.scene(0.25);
            const std::vector<Rgb> values = lit_and_dark(scene);
            const SmoothShading shading(scene, values, 1);
            for (const double z : {0.0, 0.3, 1.0})
                CHECK(on_floor(shading, one_surface, 1.0 - 1e-9, z) ==
                      doctest::Approx(on_floor(shading, one_surface, 1.0 + 1e-9, z)).epsilon(1e-6)); // of a steep ramp
        }
}

// A floor that is evenly lit where nothing stands on it: the patches below a box are black, those it covers in part are
// darker by that part.
TEST_CASE("what a box covers does not darken the floor around it")
{
    for (const double low : {0.5, 0.5625, 0.65625}) { // on the borders of patches, and across them
        SceneBuilder builder = with_lamp();
        builder.rectangle({0.0, 0.0, 0.0}, {0.0, 0.0, 2.0}, {2.0, 0.0, 0.0}, builder.grey(0.5, 0.0));
        builder.box({low, 0.0, low}, {1.25, 0.5, 1.25}, builder.grey(0.5, 0.0));
        const Scene scene = builder.scene(0.25);
        std::vector<Rgb> values(scene.patch_count(), grey(3.0));
        const auto covered = [&](double from) {
            return std::max(0.0, std::min(from + 0.25, 1.25) - std::max(from, low));
        };
        for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
            if (scene.surface_of(patch) == 1) {
                const Vec3 corner = scene.patch(patch).shape.origin;
                values[patch] = grey(3.0 * (1.0 - covered(corner.x) * covered(corner.z) / (0.25 * 0.25)));
            }
        const SmoothShading shading(scene, values, 1);
        for (double u = 0.012; u < 1.0; u += 0.03)
            for (double v = 0.012; v < 1.0; v += 0.03) {
                const bool below_box = std::min(u, v) > 0.5 * low && std::max(u, v) < 0.625;
                if (!below_box)
                    CHECK(shown(shading, 1, u, v) == doctest::Approx(3.0)); // borders of the box lie between samples
            }
    }
}

TEST_CASE("surfaces look the same if only they are shaded")
{
    for (const bool two_sided : {false, true}) {
        SceneBuilder builder = with_lamp();
        const std::uint32_t paint = builder.grey(0.5, 0.0);
        builder.rectangle({0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, paint);
        builder.rectangle({2.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, paint);
        builder.rectangle({0.5, 1.0, 0.0}, {1.5, 0.0, 0.0}, {0.0, 0.5, 0.1},
                          paint); // meets the first at a part of its edge
        builder.rectangle({2.0, 1.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.2}, paint);
        builder.triangle({0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, paint);
        builder.triangle({0.0, 1.0, 0.0}, {0.5, 0.0, 0.0}, {0.0, 1.0, 0.1}, paint);
        builder.box({1.0, 0.2, 0.0}, {1.2, 0.4, 0.5}, paint);
        const Scene scene = builder.scene(0.25, two_sided);
        const std::vector<Rgb> values = at_centres(scene, [](Vec3 p) { return 2.0 + std::sin(3.0 * p.x + 5.0 * p.y); });
        const SmoothShading all(scene, values, 1);
        for (std::uint32_t surface = 0; surface < scene.surfaces().size(); ++surface) {
            std::vector<char> asked(scene.surfaces().size());
            asked[surface] = 1;
            const SmoothShading one(scene, values, 2, asked);
            CAPTURE(surface);
            for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
                if (scene.surface_of(patch) == surface)
                    CHECK(one.at_corners(patch) == all.at_corners(patch));
        }
    }
}

// From the east at 45 degrees the shadow of a unit square 1 m above [0, 1] x [0, 1] of the floor is [-1, 0] x [0, 1].
// That of a box of half the height on [2, 3] x [-2, -1], whose bottom is not modelled, is [1.5, 2] x [-2, -1]. The
// patches, of about 0.31 m, fit no edge of them, and the box covers some in part.
TEST_CASE("a shadow in sunlight has the edges of the parallel projection")
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.rectangle({-4, 0, -4}, {0, 0, 8}, {8, 0, 0}, paint);
    builder.rectangle({0, 1, 0}, {0, 0, 1}, {1, 0, 0}, paint);
    builder.rectangle({2, 0.5, -2}, {0, 0, 1}, {1, 0, 0}, paint);
    builder.rectangle({2, 0, -2}, {0, 0, 1}, {0, 0.5, 0}, paint);
    builder.rectangle({3, 0, -2}, {0, 0.5, 0}, {0, 0, 1}, paint);
    builder.rectangle({2, 0, -2}, {0, 0.5, 0}, {1, 0, 0}, paint);
    builder.rectangle({2, 0, -1}, {1, 0, 0}, {0, 0.5, 0}, paint);
    const Scene scene = builder.sun(sun_at(90, 45, {0, 1, 0}, grey(1.0))).scene(0.31);
    const std::vector<Rgb> none(scene.patch_count());
    const VisiblePatches patches(scene, none, 1);
    std::vector<Rgb> radiosity;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) // besides the sun even light where the floor is open
        radiosity.push_back(scene.first_light(i) + grey(0.25 * patches.open_share(i)));
    const ShownRadiosity shown_radiosity(scene, radiosity, 1);
    for (int i = 0; i < 96; ++i)
        for (int j = 0; j < 96; ++j) {
            const double u = (i + 0.5) / 96; // along z
            const double v = (j + 0.5) / 96; // along x
            const Vec3 p = scene.surfaces()[0].at(u, v);
            const bool in_row = p.z > -2.0 && p.z < -1.0;
            if (in_row && p.x > 2.0 && p.x < 3.0)
                continue; // below the box
            const bool is_dark =
                (p.x > -1.0 && p.x < 0.0 && p.z > 0.0 && p.z < 1.0) || (in_row && p.x > 1.5 && p.x < 2.0);
            const double expected = 0.25 + (is_dark ? 0.0 : 0.5 * std::sqrt(0.5));
            CHECK(shown_radiosity.at({0.0, 0, u, v, true}).g == doctest::Approx(expected).epsilon(1e-9)); // rounding
        }
}

// Two rectangles that meet at 10 degrees look like one curved surface, and the sunlight on them like one slope.
TEST_CASE("sunlight on facets of a curved surface is interpolated")
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    const double slope = std::tan(10.0 * pi / 180.0);
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, paint);
    builder.rectangle({-1, -slope, 0}, {0, 0, 1}, {1, slope, 0}, paint);
    builder.rectangle({5, 0, 0}, {0, 0, 1}, {1, 0, 0}, paint);
    builder.rectangle({6.2, 1, 0.3}, {0, 0, 0.3}, {0.3, 0, 0}, paint); // casts a shadow on the third
    const Scene scene = builder.sun(sun_at(90, 45, {0, 1, 0}, grey(1.0))).scene(0.5);
    std::vector<Rgb> radiosity;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        radiosity.push_back(scene.first_light(i));
    const ShownRadiosity shown_radiosity(scene, radiosity, 1);
    const double right = shown_radiosity.at({0.0, 0, 0.5, 0.01, true}).g; // 1 cm from the seam
    const double left = shown_radiosity.at({0.0, 1, 0.5, 0.99, true}).g;
    const double sunniest = 0.5 * std::sqrt(0.5);
    const double other = 0.5 * std::cos(55.0 * pi / 180.0);
    CHECK(right < 0.9 * sunniest + 0.1 * other);
    CHECK(left > 0.9 * other + 0.1 * sunniest);
    CHECK(std::abs(right - left) < 0.1 * (sunniest - other)); // a slope 2 cm long of one at least 25 cm long
}

} // namespace smooth_shading_test
