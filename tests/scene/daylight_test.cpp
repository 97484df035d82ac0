#include "scene/daylight.h"

#include "scene/scene_builder.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace daylight_test {

using namespace multipath;

namespace {

constexpr Rgb white = {1.0, 1.0, 1.0};

/// A floor [-4, 4]^2 at y = 0 and a unit cube on it.
SceneBuilder cube_on_floor()
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    builder.rectangle({-4, 0, -4}, {0, 0, 8}, {8, 0, 0}, grey);
    builder.box({0, 0, 0}, {1, 1, 1}, grey);
    return builder;
}

bool is_near(Vec3 a, Vec3 b)
{
    return length(a - b) < 1e-9;
}

double sun_on_floor(const Scene& scene)
{
    double power = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (scene.surface_of(i) == 0)
            power += scene.area(i) * scene.sunlight(i).g;
    return power;
}

} // namespace

TEST_CASE("the sun goes from north by east to south, whichever axis is up")
{
    const Vec3 y = {0, 1, 0};
    CHECK(is_near(sun_at(0, 0, y, white).direction, {0, 0, -1}));
    CHECK(is_near(sun_at(90, 0, y, white).direction, {1, 0, 0}));
    CHECK(is_near(sun_at(180, 0, y, white).direction, {0, 0, 1}));
    CHECK(is_near(sun_at(123, 90, y, white).direction, {0, 1, 0}));
    const Vec3 z = {0, 0, 2};
    CHECK(is_near(sun_at(0, 0, z, white).direction, {0, 1, 0}));
    CHECK(is_near(sun_at(90, 0, z, white).direction, {1, 0, 0}));
    CHECK(is_near(sun_at(0, 30, z, white).direction, {0, std::sqrt(0.75), 0.5}));
}

TEST_CASE("below a slanted zenith, too, azimuths and elevations are the angles between suns")
{
    const auto above_y = [](double azimuth, double elevation) {
        return sun_at(azimuth, elevation, {0, 1, 0}, white).direction;
    };
    for (const Vec3 up : {Vec3{0, 1, 0.5}, {0.3, -0.4, 0.8}, {-2, 1, 0.1}, {0.2, 0.1, -3}}) {
        CAPTURE(up.x);
        const auto above = [&](double azimuth, double elevation) {
            return sun_at(azimuth, elevation, up, white).direction;
        };
        const Vec3 zenith = normalized(up);
        CHECK(is_near(above(77, 90), zenith));
        CHECK(is_near(cross(above(90, 0), above(0, 0)), zenith)); // clockwise from above
        for (const double elevation : {0.0, 20.0, 55.0})
            for (const double azimuth : {0.0, 35.0, 100.0, 250.0})
                CHECK(dot(above(azimuth, elevation), above(60, 40)) ==
                      doctest::Approx(dot(above_y(azimuth, elevation), above_y(60, 40))).epsilon(1e-9));
    }
}

TEST_CASE("a surface that faces the sun slantwise gets the cosine, one that looks away nothing")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, grey);
    builder.triangle({0, -1, 0}, {1, -1, 0}, {0, -1, 1}, grey); // looks down
    const Scene scene = builder.sun(sun_at(77, 30, {0, 1, 0}, {2, 4, 6})).scene(0.3);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const Rgb expected = scene.surface_of(i) == 0 ? Rgb{1, 2, 3} : Rgb{};
        CHECK(scene.sunlight(i).r == doctest::Approx(expected.r).epsilon(1e-9));
        CHECK(scene.sunlight(i).b == doctest::Approx(expected.b).epsilon(1e-9));
    }
    CHECK(scene.source_power().g == doctest::Approx(2.0));
    CHECK(scene.lamp_power().g == 0.0);
    const Vec3 up = {0, 1, 0};
    CHECK(scene.sunlight(0, {0.5, 0, 0.5}, up).g == doctest::Approx(2.0));
    CHECK(scene.sunlight(0, {0.5, 0, 0.5}, -up).g == 0.0);
}

// Points for which rounding would decide on which side of an edge they are tell nothing of a patch.
TEST_CASE("a convex body has no shadow on itself: each patch that faces the sun gets the cosine, to rounding")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    constexpr int around = 20;
    const auto at = [](int i, int j) {
        const double theta = 3.14159265358979 * i / around;
        const double phi = 2.0 * 3.14159265358979 * j / around + 0.1;
        return Vec3{-7.0 + 2.0 * std::sin(theta) * std::cos(phi), 3.0 + std::cos(theta),
                    11.0 + 1.3 * std::sin(theta) * std::sin(phi)};
    };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < around; ++j) {
            if (i > 0)
                builder.triangle(at(i, j), at(i, j + 1), at(i + 1, j), grey);
            if (i + 1 < around)
                builder.triangle(at(i + 1, j + 1), at(i + 1, j), at(i, j + 1), grey);
        }
    const Sun sun = {normalized({0.3, 0.9, -0.5}), white};
    for (const double patch_size : {0.2, 10.0}) {
        const Scene scene = builder.sun(sun).scene(patch_size);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const double cosine = std::max(0.0, dot(scene.patch(i).shape.normal(), sun.direction));
            CHECK(std::abs(scene.sunlight(i).g - cosine) <= 1e-12);
        }
    }
}

TEST_CASE("the shadow of a cube has the area of its parallel projection")
{
    // From the east at 45 degrees: 1 x 1 beyond the cube, and the 1 x 1 on which it stands.
    const Sun east = sun_at(90, 45, {0, 1, 0}, white);
    const Scene coarse = cube_on_floor().sun(east).scene(0.31);
    CHECK(sun_on_floor(coarse) == doctest::Approx((64.0 - 2.0) * std::sqrt(0.5)).epsilon(2e-4));
    // From the south-east: the projection of a cube moved by (1, 1) is a hexagon of area 3 - the square overlaps it.
    const Sun corner = sun_at(135, std::atan(std::sqrt(0.5)) * 180.0 / 3.14159265358979, {0, 1, 0}, white);
    const Scene slanted = cube_on_floor().sun(corner).scene(0.2);
    CHECK(sun_on_floor(slanted) == doctest::Approx((64.0 - 3.0) * corner.direction.y).epsilon(2e-4));
    // The same with patches cut further, for any number of threads.
    std::vector<std::uint8_t> levels;
    for (std::uint32_t i = 0; i < coarse.patch_count(); ++i)
        levels.insert(levels.end(), 4, 1);
    const Scene fine = coarse.refined(levels);
    const Scene by_threads = coarse.refined(levels, 3);
    CHECK(sun_on_floor(fine) == doctest::Approx((64.0 - 2.0) * std::sqrt(0.5)).epsilon(2e-4));
    for (std::uint32_t i = 0; i < fine.patch_count(); ++i)
        CHECK(fine.sunlight(i) == by_threads.sunlight(i));
    CHECK(coarse.hash() != cube_on_floor().sun(corner).scene(0.31).hash());
}

// The roof covers the other half of the square that the edges of the triangle span.
TEST_CASE("a triangle beside a shadow is sunlit as a whole")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    builder.triangle({0, 0, 0}, {0, 0, 4}, {4, 0, 0}, grey);
    builder.triangle({4, 1, 4}, {4, 1, 0.1}, {0.1, 1, 4}, grey);
    const Scene scene = builder.sun(sun_at(0, 90, {0, 1, 0}, white)).scene(100);
    CHECK(sun_on_floor(scene) == doctest::Approx(8.0));
}

TEST_CASE("the sky surrounds the scene, emits inward, and is no part of it")
{
    SceneFile file = cube_on_floor().file();
    add_sky(file, {1, 2, 3});
    file.sun = sun_at(90, 45, {0, 1, 0}, white);
    const Scene scene(file, 0.5, true);
    CHECK(scene.own_surfaces() == 7);
    REQUIRE(scene.surfaces().size() == 13);
    const Vec3 middle = scene.own_bounds().centre();
    double weight = 0.0;
    for (std::uint32_t s = 0; s < 13; ++s) {
        CHECK(scene.is_sky(s) == (s >= 7));
        if (scene.is_sky(s)) {
            CHECK(dot(middle - scene.surfaces()[s].centre(), scene.surfaces()[s].normal()) > 0.0);
            CHECK(scene.tessellation(s).cell_count() == 1);
            CHECK(scene.emittance(scene.first_patch(s)) == Rgb{1, 2, 3});
            CHECK(scene.reflectance(scene.first_patch(s)) == Rgb{});
        }
    }
    for (const double w : scene.weights())
        weight += w;
    CHECK(weight == doctest::Approx(2.0 * (64 + 6)));
    CHECK(scene.own_area() == doctest::Approx(2.0 * (64 + 6)));
    CHECK(scene.own_bounds().low == Vec3{-4, 0, -4});
    CHECK(scene.bounds().low.x < -4.1);
    // The sun shines through the sky.
    CHECK(sun_on_floor(scene) == doctest::Approx((64.0 - 2.0) * std::sqrt(0.5)).epsilon(1e-3));
    CHECK(cell_count(file, 0.5) == scene.patch_count() / 2);
}

} // namespace daylight_test
