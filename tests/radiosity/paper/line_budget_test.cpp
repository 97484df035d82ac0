#include "radiosity/paper/line_budget.h"

#include "radiosity/paper/direct_light.h"
#include "scene/daylight.h"
#include "test_scenes.h"

#include <cmath>
#include <doctest/doctest.h>

namespace line_budget_test {

using namespace multipath;

// The paper's section 4.2 prints these three; 0.005 is half a unit of its last digit.
TEST_CASE("formula (3) gives the ratios that the paper prints")
{
    const auto ratio = [](double r_s, double f) { return optimal_ratio({2.1, 0.577, r_s, f}).value(); };
    CHECK(ratio(0.7, 0.073) == doctest::Approx(0.41).epsilon(0.005 / 0.41));
    CHECK(ratio(0.65, 0.67) == doctest::Approx(0.85).epsilon(0.005 / 0.85));
    CHECK(ratio(0.577, 1.0) == doctest::Approx(1.06).epsilon(0.005 / 1.06));
    CHECK(optimal_ratio(extended_figures({2.1, 0.577, 0.7, 0.073})).value() == doctest::Approx(ratio(0.577, 1.0)));
}

TEST_CASE("formula (3) has no value where the sources light nothing that reflects")
{
    CHECK_FALSE(optimal_ratio({2.1, 0.577, 0.0, 0.0}));
    CHECK_FALSE(optimal_ratio({2.1, 0.577, 0.0, 0.3}));
    CHECK(optimal_ratio({2.1, 0.577, 0.7, 1e-6}));
}

TEST_CASE("the local lines of a budget are their share by the ratio, and never more than all")
{
    for (const double ratio : {0.0, 0.41, 1.0, 3.0, 1e9})
        for (const std::uint64_t lines : {1ull, 2ull, 1000001ull}) {
            const std::uint64_t local = local_line_count(lines, ratio);
            CHECK(local <= lines);
            CHECK(std::abs(static_cast<double>(local) - static_cast<double>(lines) * ratio / (1 + ratio)) <=
                  0.5 + 1e-9);
        }
}

// Every line that meets an empty closed box crosses its walls exactly twice. A cube of edge 1/2 inside a unit cube adds
// 2 (6/4) / 6.
TEST_CASE("a line through an empty room meets its walls twice")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 1.0);
    CHECK(intersections_per_line(builder.room({0, 0, 0}, {3, 2, 1}, wall).scene(1.0)) == doctest::Approx(2.0));
    SceneBuilder furnished;
    const std::uint32_t grey = furnished.grey(0.5, 1.0);
    furnished.room({0, 0, 0}, {1, 1, 1}, grey).box({0.2, 0.2, 0.2}, {0.7, 0.7, 0.7}, grey);
    CHECK(intersections_per_line(furnished.scene(1.0)) == doctest::Approx(2.5));
    CHECK(intersections_per_line(Scene(furnished.file(), 1.0, true)) == doctest::Approx(2.5));
}

// (4) is the reflected radiosity if the light were spread evenly: Phi_T / A_T times rho + rho^2 + ..., with the furnace
// as its exact case.
TEST_CASE("the threshold is the mean reflected radiosity of a furnace")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.6, 2.0);
    const Scene scene = builder.room({0, 0, 0}, {1, 1, 1}, wall).scene(1.0);
    CHECK(threshold_radiosity(scene) == doctest::Approx(2.0 / (1 - 0.6) - 2.0));
}

// By power: that of a lamp is A E, of a sky the same with its six sides, and of the sun A E cos.
TEST_CASE("the threshold is the same for equal power of a lamp, the sky and the sun, and that of all is the sum")
{
    const auto threshold = [](double lamp, double sky, double sun) {
        SceneBuilder builder;
        builder.rectangle({-9, 2, 5}, {0, 3, 0}, {0, 0, 2}, builder.material({0.9, 0.2, 0.4}, {})); // looks along x
        builder.rectangle({-9, 2, 5}, {0, 1, 0}, {2, 0, 0}, builder.material({0.1, 0.3, 0.0}, {0.0, lamp, 2.0 * lamp}));
        builder.sun({normalized({3, 4, 0}), {sun, 2.0 * sun, 0.0}}); // on the first alone
        SceneFile file = builder.file();
        add_sky(file, {0.0, 0.0, sky});
        return threshold_radiosity(Scene(file, 0.7));
    };
    const double margin = 0.05 * std::sqrt(4.0 + 9.0 + 4.0);
    const Vec3 box = Vec3{2, 3, 2} + 2.0 * Vec3{margin, margin, margin};
    const double lamp_power = 2.0 * 3.0 / 3.0;
    const double sky_power = 2.0 * (box.x * box.y + box.y * box.z + box.z * box.x) / 3.0;
    const double sun_power = 6.0 * 0.6 * 3.0 / 3.0;
    const double of_lamp = threshold(1, 0, 0) / lamp_power;
    CHECK(threshold(0, 1, 0) / sky_power == doctest::Approx(of_lamp));
    CHECK(threshold(0, 0, 1) / sun_power == doctest::Approx(of_lamp));
    CHECK(threshold(5, 3, 4) == doctest::Approx(of_lamp * (5 * lamp_power + 3 * sky_power + 4 * sun_power)));
}

// A lamp covers the ceiling of a unit cube: it lights the floor and the walls, 5/6 of the area, but not itself. The
// floor receives F = 0.199825 of its power, each wall 0.200044.
TEST_CASE("the direct light of a ceiling lamp is measured")
{
    SceneBuilder builder;
    const std::uint32_t lamp = builder.grey(0.0, 1.0);
    const std::uint32_t floor = builder.grey(0.9, 0.0);
    const std::uint32_t wall = builder.grey(0.3, 0.0);
    const Scene scene = builder.room({0, 0, 0}, {1, 1, 1}, {floor, lamp, wall, wall, wall, wall}).scene(1.0);
    const DirectLight light = measure_direct_light(scene, 100000, 2);
    CHECK(light.lit_fraction == doctest::Approx(5.0 / 6.0));
    const double f = 0.199825;
    const double reflectance = 0.9 * f + 0.3 * (1 - f);
    CHECK(light.secondary_reflectance ==
          doctest::Approx(reflectance).epsilon(0.002)); // 100,000 rays: 0.2 % is > 4 sigma
}

// 7,500 tiles of 0.005 m^2 that face a small lamp and 7,500 of 0.05 m^2 that face away: more than are looked at one by
// one. The tiles of a kind are either together, as in the grids of two walls, where the choice by area is off by one of
// 8,192 pieces at most; or in turns, where looking at every second tile would find one kind only. Then the choice is
// random: four standard deviations, sqrt(f (1 - f) / 8192) each.
TEST_CASE("the lit fraction of more patches than are looked at is right, whatever their order and areas")
{
    constexpr int count = 7500;
    constexpr double lamp_area = 0.01;
    constexpr double lit = count * 0.005 / (count * 0.055 + lamp_area);
    for (const bool in_turns : {false, true}) {
        CAPTURE(in_turns);
        SceneBuilder builder;
        const std::uint32_t lamp = builder.grey(0.0, 1.0);
        const std::uint32_t tile = builder.grey(0.5, 0.0);
        const auto add = [&](int k, bool faces_lamp) {
            const Vec3 corner = {0.4 * (k % 100), 0.0, 0.4 * (k / 100)};
            if (faces_lamp)
                builder.rectangle(corner, {0, 0, 0.1}, {0.05, 0, 0}, tile);
            else
                builder.rectangle(corner + Vec3{0.1, 0, 0}, {0.25, 0, 0}, {0, 0, 0.2}, tile);
        };
        for (int k = 0; k < 2 * count; ++k)
            add(in_turns ? k / 2 : k % count, in_turns ? k % 2 == 0 : k < count);
        builder.rectangle({20, 10, 15}, {0.1, 0, 0}, {0, 0, 0.1}, lamp);
        const Scene scene = builder.scene(100.0);
        CHECK(scene.patch_count() == 2 * count + 1);
        const double found = measure_direct_light(scene, 1u << 13, 2).lit_fraction;
        CAPTURE(found);
        CHECK(std::abs(found - lit) <= (in_turns ? 4.0 * std::sqrt(lit * (1.0 - lit) / 8192) : 1.0 / 8192));
    }
}

// A lamp stands upright at x = 0 above a shelf that ends at x = 0.5, level with the lamp's lower edge. Its highest
// point, twice as high as the shelf, sees the floor from x = 1 on. Floor cells are 0.5 wide and displaced, so that x =
// 1 lies just before the end of a cell: of the cells from 0.51 to 1.01 the last 2 % are lit. f counts them whole.
TEST_CASE("a patch of which the light reaches no more than the border counts as lit")
{
    SceneBuilder builder;
    const std::uint32_t lamp = builder.grey(0.0, 1.0);
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    builder.rectangle({0, 1, 0}, {0, 1, 0}, {0, 0, 1}, lamp);
    builder.rectangle({0, 1, 0}, {0, 0, 1}, {0.5, 0, 0}, grey);
    builder.rectangle({0.01, 0, 0}, {0, 0, 1}, {2.5, 0, 0}, grey);
    const Scene scene = builder.scene(0.5);
    const double dark = 1.0 * 0.5; // the first column; the second, from 0.51 to 1.01, is the partly lit one
    CHECK(measure_direct_light(scene, 1u << 18, 2).lit_fraction == doctest::Approx((4.0 - 1.0 - dark) / 4.0));
}

} // namespace line_budget_test
