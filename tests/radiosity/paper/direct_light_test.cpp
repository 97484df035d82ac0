#include "radiosity/paper/direct_light.h"

#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <vector>

namespace direct_light_test {

using namespace multipath;

// A lamp far above a field of squares and strips by turns, with nothing in between: all but the lamp is lit, in
// whatever proportion the patches that are looked at stand for the others.
TEST_CASE("of an open field all is lit, also where some patches stand for many of other sizes")
{
    constexpr int columns = 75;
    constexpr int rows = 75;
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j) {
            const double x = i;
            const double z = 1.1 * j;
            builder.rectangle({x, 0, z}, {0, 0, 1}, {1, 0, 0}, grey);
            builder.rectangle({x, 0, z + 1.0}, {0, 0, 0.1}, {1, 0, 0}, grey);
        }
    builder.rectangle({35, 90, 40}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.5, 1.0));
    const Scene scene = builder.scene(1.0);
    REQUIRE(scene.patch_count() == 2 * columns * rows + 1); // more than are looked at
    const double lit = 1.1 * columns * rows;
    CHECK(measure_direct_light(scene, 1000, 1).lit_fraction == doctest::Approx(lit / (lit + 1.0)).epsilon(1e-3));
}

// 32,768 squares face the lamp and turn their back to it by turns. A choice at equal distances, here 4 squares, meets
// only the ones or only the others.
TEST_CASE("the patches that stand for others are not chosen in step with them")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    for (int i = 0; i < 128; ++i)
        for (int j = 0; j < 256; ++j) {
            const Vec3 x = {1, 0, 0};
            const Vec3 z = {0, 0, 1};
            builder.rectangle({1.0 * i, 0, 1.0 * j}, j % 2 == 0 ? z : x, j % 2 == 0 ? x : z, grey);
        }
    builder.rectangle({64, 200, 128}, {0.1, 0, 0}, {0, 0, 0.1}, builder.grey(0.5, 1.0)); // looks down
    const Scene scene = builder.scene(1.0);
    REQUIRE(scene.patch_count() == 32769);
    const double five_sigma = 5.0 * 0.5 / std::sqrt(8192.0);
    CHECK(std::abs(measure_direct_light(scene, 4096, 1).lit_fraction - 0.5) < five_sigma);
}

// A screen just below the lamp takes all its light; what completes the lamp to a square would pass it.
TEST_CASE("a triangle lights nothing from beside it")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    builder.triangle({0, 4, 0}, {1, 4, 0}, {0, 4, 1}, builder.grey(0.0, 1.0)); // looks down
    builder.triangle({-0.02, 3.99, -0.02}, {-0.02, 3.99, 1.06}, {1.06, 3.99, -0.02}, grey);
    builder.rectangle({0.8, 0, 0.8}, {0, 0, 0.2}, {0.2, 0, 0}, grey);
    const Scene scene = builder.scene(100.0);
    CHECK(measure_direct_light(scene, 1u << 12, 1).lit_fraction ==
          doctest::Approx(0.5 * 1.08 * 1.08 / scene.total_area()));
}

// Two faces of a triangular pyramid are in the sun, one is not, and none sees another. What a face reflects is known.
TEST_CASE("the figures of the direct light are means by area, whatever the patches and colours")
{
    const Rgb irradiance = {5.0, 0.0, 3.0};
    const Vec3 towards_sun = normalized({2.0, -1.0, 1.0});
    const Vec3 top = {-3.0, 2.0, 9.0};
    const std::vector<Vec3> base = {{-4.0, 1.0, 5.0}, {-1.0, 0.5, 6.0}, {-2.5, 5.0, 6.5}};
    const std::vector<Rgb> reflectance = {{0.9, 0.1, 0.4}, {0.2, 0.8, 0.0}, {0.5, 0.5, 0.5}};
    SceneBuilder builder;
    for (std::size_t k = 0; k < 3; ++k)
        builder.triangle(base[k], base[(k + 1) % 3], top,
                         builder.material(reflectance[k], {0.0, k == 1 ? 4.0 : 0.0, 0.0}));
    const Scene scene = unevenly_refined(builder.sun({towards_sun, irradiance}).scene(1.5));
    double received = 0.0;
    double reflected = 0.0;
    int lit = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Surface& face = scene.surfaces()[k];
        const double cosine = std::max(0.0, dot(face.normal(), towards_sun));
        const double b = cosine * mean(reflectance[k] * irradiance);
        lit += cosine > 0.0 ? 1 : 0;
        received += face.area() * cosine * mean(irradiance);
        reflected += face.area() * b;
    }
    REQUIRE(lit == 2);
    const DirectLight light = measure_direct_light(scene, 100, 1);
    CHECK(light.secondary_reflectance == doctest::Approx(reflected / received));
    CHECK(light.lit_fraction == 0.0); // by the light that the faces send
}

} // namespace direct_light_test
