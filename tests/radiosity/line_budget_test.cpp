#include "radiosity/line_budget.h"

#include "radiosity/direct_light.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

using namespace multipath;

// The paper's section 4.2 prints these three; 0.005 is half a unit of its last digit.
TEST_CASE("formula (3) gives the ratios that the paper prints")
{
    const auto ratio = [](double r_s, double f) { return optimal_ratio({2.1, 0.577, r_s, f}); };
    CHECK(ratio(0.7, 0.073) == doctest::Approx(0.41).epsilon(0.005 / 0.41));
    CHECK(ratio(0.65, 0.67) == doctest::Approx(0.85).epsilon(0.005 / 0.85));
    CHECK(ratio(0.577, 1.0) == doctest::Approx(1.06).epsilon(0.005 / 1.06));
    CHECK(optimal_ratio(extended_figures({2.1, 0.577, 0.7, 0.073})) == doctest::Approx(ratio(0.577, 1.0)));
}

TEST_CASE("a budget is split without losing a line")
{
    for (const double ratio : {0.0, 0.41, 1.0, 3.0, 1e9})
        for (const std::uint64_t lines : {1ull, 2ull, 1000001ull}) {
            const LineBudget budget = split_lines(lines, ratio);
            CHECK(budget.local_lines + budget.global_lines == lines);
            CHECK(std::abs(static_cast<double>(budget.local_lines) -
                           static_cast<double>(lines) * ratio / (1 + ratio)) <= 0.5 + 1e-9);
        }
}

// Every line that meets an empty closed box crosses its walls exactly twice. A cube of edge 1/2 inside a unit cube adds
// 2 (6/4) / 6.
TEST_CASE("a line through an empty room meets its walls twice")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 1.0);
    CHECK(intersections_of_hull_line(builder.room({0, 0, 0}, {3, 2, 1}, wall).scene(1.0)) == doctest::Approx(2.0));
    SceneBuilder furnished;
    const std::uint32_t grey = furnished.grey(0.5, 1.0);
    furnished.room({0, 0, 0}, {1, 1, 1}, grey).box({0.2, 0.2, 0.2}, {0.7, 0.7, 0.7}, grey);
    CHECK(intersections_of_hull_line(furnished.scene(1.0)) == doctest::Approx(2.5));
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
    const double walls = 0.3 * (1 - f) / 4;
    const double squares = 0.9 * f * 0.9 * f + 4 * walls * walls;
    CHECK(light.effective_fraction == doctest::Approx(reflectance * reflectance / (6 * squares)).epsilon(0.01));
}
