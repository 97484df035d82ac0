#include "image/gather/source_light.h"

#include "base/elementary.h"
#include "geometry/intersector/intersector.h"
#include "sampling/sequence.h"
#include "scene/daylight.h"
#include "scene/obj/obj_reader.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace source_light_test {

using namespace multipath;

namespace {

const GatherPoint origin = {
    0, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}; // of no known patch: every source is asked for by rays

/// [W/m^2] At the origin, by so many rays.
Rgb irradiance_by(std::size_t rays, const SourceLight& light, double offset)
{
    RayFan fan;
    return light.irradiance(origin, {*make_sequence("sobol-owen", 7), 0, rays}, offset, fan);
}

/// A spot of floor whose middle is the origin, as the first surface of a scene.
SceneBuilder with_floor()
{
    SceneBuilder builder;
    return builder.rectangle({-0.1, 0.0, -0.1}, {0.0, 0.0, 0.2}, {0.2, 0.0, 0.0}, builder.grey(0.5, 0.0));
}

/// Form factor from a spot to a rectangle a x b parallel to it at distance 1, one corner right above the spot (Howell,
/// A Catalog of Radiation Heat Transfer Configuration Factors, B-3).
double corner_factor(double a, double b)
{
    const double x = std::sqrt(1.0 + a * a);
    const double y = std::sqrt(1.0 + b * b);
    return (a / x * std::atan(b / x) + b / y * std::atan(a / y)) / (2.0 * pi);
}

/// A square of 1 m^2 that faces the floor, its middle 1 m above the origin.
SceneBuilder with_lamp(Rgb emittance)
{
    SceneBuilder builder = with_floor();
    return builder.rectangle({-0.5, 1.0, -0.5}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, builder.material({}, emittance));
}

/// A floor of 2 x 2 patches of 1 m, and 1 m above the one at the origin a lamp of 1 m^2 that looks down.
SceneBuilder lit_floor()
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {0, 0, 2}, {2, 0, 0}, builder.grey(0.5, 0.0));
    return builder.rectangle({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.0, 1.0));
}

/// True if the lamp is fully visible from the patch under the point (x, 0, z).
bool is_clear(const Scene& scene, double x, double z)
{
    return ShaftVisibility(scene, 1).is_fully_visible(scene.patch_at(0, z / 2, x / 2, true), 0, 1);
}

} // namespace

TEST_CASE("the irradiance from a source in full sight is exact with a single ray")
{
    const Scene scene = with_lamp({3.0, 2.0, 0.0}).scene(1.0);
    const double factor = 4.0 * corner_factor(0.5, 0.5);
    for (const double offset : {0.0, 0.3, 0.999}) {
        const Rgb irradiance = irradiance_by(1, SourceLight(scene), offset);
        CHECK(irradiance.r == doctest::Approx(3.0 * factor).epsilon(1e-12)); // rounding
        CHECK(irradiance.g == doctest::Approx(2.0 * factor).epsilon(1e-12));
        CHECK(irradiance.b == 0.0);
    }
}

// A board half way up, whose edge lies right above the origin, hides half of the source.
TEST_CASE("of a source half hidden arrives half")
{
    SceneBuilder builder = with_lamp({1.0, 1.0, 1.0});
    const Scene scene =
        builder.rectangle({0.0, 0.5, -2.0}, {0.0, 0.0, 4.0}, {2.0, 0.0, 0.0}, builder.grey(0.5, 0.0)).scene(1.0);
    const double half = 2.0 * corner_factor(0.5, 0.5);
    // An edge crosses about the root of the number of the strata: 4 of the resulting errors.
    CHECK(irradiance_by(256, SourceLight(scene), 0.0).r ==
          doctest::Approx(half).epsilon(4.0 * std::pow(256.0, -0.75)).scale(0.0));
}

// A strip that reaches far to one side, of which a board hides all beyond 1 m: what is left gives more than its part of
// the solid angle, since it is seen less at a slant.
TEST_CASE("of a source partly hidden arrives what its part in sight gives")
{
    SceneBuilder builder = with_floor();
    builder.rectangle({0.0, 1.0, -0.5}, {10.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, builder.grey(0.0, 1.0));
    builder.rectangle({0.5, 0.5, -2.0}, {0.0, 0.0, 4.0}, {9.0, 0.0, 0.0}, builder.grey(0.5, 0.0));
    const double in_sight = 2.0 * corner_factor(1.0, 0.5);
    CHECK(irradiance_by(256, SourceLight(builder.scene(20.0)), 0.0).r ==
          doctest::Approx(in_sight).epsilon(4.0 * std::pow(256.0, -0.75)).scale(0.0));
}

TEST_CASE("behind a board nothing arrives, nor from a source that faces away or lies below the horizon")
{
    SceneBuilder hidden = with_lamp({1.0, 1.0, 1.0});
    hidden.rectangle({-1.0, 0.5, -1.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 2.0}, hidden.grey(0.5, 0.0));
    CHECK(irradiance_by(16, SourceLight(hidden.scene(1.0)), 0.0) == Rgb{});

    SceneBuilder away = with_floor();
    away.rectangle({-0.5, 1.0, -0.5}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, away.grey(0.0, 1.0));
    away.rectangle({-0.5, -1.0, -0.5}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, away.grey(0.0, 1.0));
    CHECK(irradiance_by(16, SourceLight(away.scene(1.0)), 0.0) == Rgb{});
}

// The same square in 10 x 10 sources: more than are looked at from one receiver.
TEST_CASE("many sources give on the average what they give together")
{
    SceneBuilder builder = with_floor();
    const std::uint32_t lamp = builder.grey(0.0, 1.0);
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j)
            builder.rectangle({-0.5 + 0.1 * i, 1.0, -0.5 + 0.1 * j}, {0.1, 0.0, 0.0}, {0.0, 0.0, 0.1}, lamp);
    const Scene scene = builder.scene(1.0);
    const SourceLight light(scene);
    double sum = 0.0;
    constexpr int offsets = 1000;
    for (int k = 0; k < offsets; ++k)
        sum += irradiance_by(4, light, (k + 0.5) / offsets).r;
    // Each source counts with a share of the offsets that these tell to a thousandth at worst, too much or too little.
    CHECK(sum / offsets == doctest::Approx(4.0 * corner_factor(0.5, 0.5)).epsilon(1e-4));
}

// A lamp that stands upright, most of it below the horizon, whole and cut into 40 upright strips: more than are looked
// at from one receiver, all with their centres below the horizon.
TEST_CASE("a lamp half below the horizon gives the same in one piece and in forty")
{
    const auto lit_by_strips = [](int count) {
        SceneBuilder builder = with_floor();
        const std::uint32_t lamp = builder.grey(0.0, 1.0);
        for (int k = 0; k < count; ++k)
            builder.rectangle({2.0 * k / count - 1.0, -1.5, -1.0}, {2.0 / count, 0, 0}, {0, 2.0, 0}, lamp);
        const Scene scene = builder.scene(1.0);
        const SourceLight light(scene);
        double sum = 0.0;
        constexpr int offsets = 1000;
        for (int k = 0; k < offsets; ++k)
            sum += irradiance_by(4, light, (k + 0.5) / offsets).r;
        return sum / offsets;
    };
    const double whole = lit_by_strips(1);
    CHECK(whole > 0.01);
    CHECK(lit_by_strips(40) ==
          doctest::Approx(whole).epsilon(1e-3).scale(0.0)); // a strip's share of the offsets, to a thousandth
}

// Lamps far away have most of the power, a small one close by gives most of the light: it is never left out.
TEST_CASE("of many sources those are looked at that give the most here")
{
    SceneBuilder builder = with_floor();
    const std::uint32_t lamp = builder.grey(0.0, 1.0);
    builder.rectangle({-0.05, 0.1, -0.05}, {0.1, 0.0, 0.0}, {0.0, 0.0, 0.1}, lamp);
    for (int k = 0; k < 99; ++k)
        builder.rectangle({k - 50.0, 40.0, -0.5}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, lamp);
    const Scene scene = builder.scene(1.0);
    const SourceLight light(scene);
    const double near_by = 4.0 * corner_factor(0.5, 0.5); // the same seen from ten times as close
    for (int k = 0; k < 20; ++k) {
        const double found = irradiance_by(64, light, (k + 0.5) / 20.0).r;
        CHECK(found > 0.9 * near_by);
        CHECK(found < 1.2 * near_by);
    }
}

// Two squares of different size and colour, the red one hidden: what is left is the green one's closed form, whichever
// rays go where, but for the rounding of two to whole rays.
TEST_CASE("a hidden source takes nothing from another one's colour")
{
    SceneBuilder builder = with_floor();
    builder.rectangle({0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, builder.material({}, {2.0, 0.0, 0.0}));
    builder.rectangle({-1.0, 1.0, -1.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, builder.material({}, {0.0, 1.0, 0.0}));
    builder.rectangle({0.0, 0.5, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, builder.grey(0.5, 0.0));
    const Scene scene = builder.scene(2.0);
    const Rgb irradiance = irradiance_by(16, SourceLight(scene), 0.5);
    CHECK(irradiance.r == 0.0);
    CHECK(irradiance.g == doctest::Approx(corner_factor(1.0, 1.0)).epsilon(1e-12)); // rounding
}

TEST_CASE("a patch and a lamp see each other clearly if nothing reaches between them")
{
    CHECK(is_clear(lit_floor().scene(1.0), 0.5, 0.5));
    CHECK(is_clear(lit_floor().scene(1.0), 1.5, 1.5));

    SceneBuilder walled = lit_floor(); // walls at the edge of the floor, of the lamp, and a ceiling that holds the lamp
    walled.rectangle({0, 0, 0}, {0, 3, 0}, {2, 0, 0}, walled.grey(0.5, 0.0));
    walled.rectangle({-4, 1, -4}, {8, 0, 0}, {0, 0, 8}, walled.grey(0.5, 0.0));
    CHECK(is_clear(walled.scene(1.0), 0.5, 0.5));

    SceneBuilder board = lit_floor(); // a small one half way up
    board.rectangle({0.4, 0.5, 0.4}, {0.01, 0, 0}, {0, 0, 0.01}, board.grey(0.5, 0.0));
    CHECK_FALSE(is_clear(board.scene(1.0), 0.5, 0.5));
    CHECK(is_clear(board.scene(1.0), 1.5, 1.5));

    SceneBuilder sheet = lit_floor(); // flat on one of the patches
    sheet.rectangle({1.2, 0, 1.2}, {0.5, 0, 0}, {0, 0, 0.5}, sheet.grey(0.5, 0.0));
    CHECK_FALSE(is_clear(sheet.scene(1.0), 1.5, 1.5));
    CHECK(is_clear(sheet.scene(1.0), 0.5, 0.5));

    CHECK_FALSE(ShaftVisibility(lit_floor().scene(1.0), 1).is_fully_visible(Scene::no_patch, 0, 1));
}

TEST_CASE("no ray between a patch and a lamp in clear sight of it meets anything else")
{
    for (const char* file : {"scenes/4chairs.obj", "scenes/5cubes.obj"}) {
        const Scene scene(read_obj(file), 0.25);
        std::uint32_t lamp = 0;
        while (scene.emittance(scene.first_patch(lamp)) == Rgb{})
            ++lamp;
        const ShaftVisibility shafts(scene, 1);
        const Surface& source = scene.surfaces()[lamp];
        std::vector<Item> items(50);
        int clear = 0;
        int hidden = 0;
        for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
            const Surface shape = scene.patch(patch).shape;
            REQUIRE(shape.shape == Shape::parallelogram);
            if (!shafts.is_fully_visible(patch, 0, lamp))
                continue;
            ++clear;
            make_sequence("random", patch)->generate(0, items);
            for (const Item& item : items) {
                const Vec3 from = shape.at(item[0], item[1]);
                const Vec3 way = source.at(item[2], item[3]) - from;
                if (dot(way, shape.normal()) <= 0.0 || dot(way, source.normal()) >= 0.0)
                    continue; // behind a horizon
                const std::uint32_t own = scene.surface_of(patch);
                const std::optional<Hit> hit = scene.intersector().closest_hit_from(own, {from, normalized(way)});
                hidden += !hit || hit->surface != lamp ? 1 : 0;
            }
        }
        CHECK(clear > static_cast<int>(scene.patch_count()) / 5);
        CHECK(hidden == 0);
    }
}

TEST_CASE("the sun lights a point beside lamps, unless something hides it")
{
    const auto irradiance = [](SceneBuilder builder) {
        builder.sun(sun_at(0, 30, {0, 1, 0}, {10, 20, 30}));
        return irradiance_by(16, SourceLight(builder.scene(1.0)), 0.0);
    };
    CHECK(irradiance(with_floor()).g == doctest::Approx(20.0 * 0.5)); // sin 30 degrees
    const double by_lamp = 4.0 * corner_factor(0.5, 0.5);
    CHECK(irradiance(with_lamp({1, 1, 1})).b == doctest::Approx(30.0 * 0.5 + by_lamp));
    SceneBuilder roofed = with_floor();
    roofed.rectangle({-9, 1, -9}, {18, 0, 0}, {0, 0, 18}, roofed.grey(0.0, 0.0));
    CHECK(irradiance(roofed) == Rgb{});
}

} // namespace source_light_test
