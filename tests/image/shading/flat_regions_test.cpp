#include "image/shading/flat_regions.h"

#include "geometry/intersector/intersector.h"
#include "image/shading/smooth_shading.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>

namespace flat_regions_test {

using namespace multipath;

namespace {

/// A wall as a fan of needles around its corner, and a lamp before it.
SceneBuilder fan(double width = 4.0, double height = 4.0)
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    constexpr int count = 40;
    const auto rim = [&](int k) {
        return k <= count ? Vec3{width, height * k / count, 0} : Vec3{width * (2 * count - k) / count, height, 0};
    };
    for (int k = 0; k < 2 * count; ++k)
        builder.triangle({0, 0, 0}, rim(k), rim(k + 1), paint);
    return builder.rectangle({0, 0, 9}, {0, 1, 0}, {1, 0, 0}, builder.grey(0.0, 1.0));
}

/// One value per patch: a ramp over the wall, and noise.
std::vector<Rgb> ramp(const Scene& scene, double noise)
{
    std::vector<Rgb> values;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const Vec3 p = scene.patch(i).shape.centre();
        const double value = 1.0 + 0.2 * p.x + 0.1 * p.y + noise * (bits_to_unit(random_bits(1, i)) - 0.5);
        values.push_back({value, value, value});
    }
    return values;
}

double largest_error(const Scene& scene, const SmoothShading& shading, double width = 4.0, double height = 4.0)
{
    double largest = 0.0;
    for (double x = 0.5; x < width; x += 0.1)
        for (double y = 0.5; y < height; y += 0.1) {
            const Hit hit = *scene.intersector().closest_hit({{x, y, 1.0}, {0, 0, -1}});
            largest = std::max(largest, std::abs(shading.at(hit).r - (1.0 + 0.2 * x + 0.1 * y)));
        }
    return largest;
}

} // namespace

TEST_CASE("a ramp over a wall of needles is reproduced")
{
    const Scene scene = fan().scene(0.5);
    const std::vector<Rgb> values = ramp(scene, 0.0);
    // Exact but for a rim half a patch wide, where the fit is kept within the values of the patches.
    CHECK(largest_error(scene, SmoothShading(scene, values, 1)) < 0.05);
}

// Some hundred patches within reach of each corner: their noise, uniform in +-0.25, falls to a tenth.
TEST_CASE("noise of needles does not show as streaks")
{
    const Scene scene = fan().scene(0.5);
    const std::vector<Rgb> values = ramp(scene, 0.5);
    CHECK(largest_error(scene, SmoothShading(scene, values, 1)) < 0.1);
}

// The axes of the region lie along the wall and upwards.
TEST_CASE("noise does not show over a wall that is taller than wide, or wider than tall")
{
    for (const double width : {3.0, 8.0}) {
        const double height = 24.0 / width;
        CAPTURE(width);
        const Scene scene = fan(width, height).scene(0.5);
        const SmoothShading shading(scene, ramp(scene, 0.5), 1);
        CHECK(largest_error(scene, shading, width, height) < 0.12);
    }
}

TEST_CASE("regions hold needles and what shares their plane and material, and nothing else")
{
    SceneBuilder builder = fan();
    builder.triangle({4, 0, 0}, {8, 4, 0}, {4, 4, 0}, 0);                      // beside: shares no edge
    builder.triangle({4, 0, 0}, {8, 0, 0}, {4, 4, 0}, builder.grey(0.2, 0.0)); // another material
    builder.triangle({0, 0, 0}, {0, 4, 4}, {0, 4, 0}, 0);                      // another plane
    builder.triangle({0, 0, 0}, {0, 4, 0}, {-4, 0, 0}, 0);                     // counter-clockwise, no shared edge
    const Scene scene = builder.scene(0.5);
    const std::vector<Rgb> values = ramp(scene, 0.0);
    const VisiblePatches patches(scene, values, 1);
    std::vector<Vec3> normals;
    for (const Surface& surface : scene.surfaces())
        normals.push_back(surface.normal());
    const FlatRegions regions(patches, normals);
    for (std::uint32_t surface = 0; surface < 80; ++surface)
        CHECK(regions.contains(surface));
    for (std::uint32_t surface = 80; surface < scene.surfaces().size(); ++surface)
        CHECK_FALSE(regions.contains(surface));
}

TEST_CASE("a wall that stands on needles parts their light")
{
    SceneBuilder builder = fan();
    builder.rectangle({2, 0, 0}, {0, 4, 0}, {0, 0, 1}, 0).rectangle({2, 0, 0}, {0, 0, 1}, {0, 4, 0}, 0);
    const Scene scene = builder.scene(0.25);
    std::vector<Rgb> values;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        values.push_back(scene.patch(i).shape.centre().x < 2.0 ? Rgb{1, 1, 1} : Rgb{});
    const SmoothShading shading(scene, values, 1);
    for (double y = 0.7; y < 3.5; y += 0.1) {
        CHECK(shading.at(*scene.intersector().closest_hit({{1.7, y, 0.5}, {0, 0, -1}})).r > 0.9);
        CHECK(shading.at(*scene.intersector().closest_hit({{2.3, y, 0.5}, {0, 0, -1}})).r < 0.1);
    }
}

} // namespace flat_regions_test
