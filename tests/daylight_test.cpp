// Light from outside, by every method. "Within 4 standard errors": see laws_test.cpp.

#include "scene/daylight.h"

#include "seeded_runs.h"
#include "test_scenes.h"

#include <array>
#include <cmath>
#include <doctest/doctest.h>

namespace daylight_methods_test {

using namespace multipath;

namespace {

Scene under_sky(SceneFile file, Rgb emittance, double patch_size, bool two_sided = false)
{
    add_sky(file, emittance);
    return Scene(std::move(file), patch_size, two_sided);
}

} // namespace

// Whatever is white under a uniform sky sends as much light as the sky: nobody could see it.
TEST_CASE("white bodies vanish before the sky" * doctest::test_suite("statistics"))
{
    SceneBuilder builder;
    const std::uint32_t white = builder.grey(1.0, 0.0);
    builder.box({0, 0, 0}, {1, 1, 1}, white).box({0.2, 1.0, 0.2}, {0.6, 1.5, 0.6}, white); // one on the other
    builder.box({1.2, 0, 0}, {1.3, 1.5, 1}, white);
    const Scene scene = under_sky(builder.file(), {1.0, 2.0, 3.0}, 1.0);
    for (const Method method : all_methods()) {
        CAPTURE(method->name);
        for (const Estimate& b : radiosities(scene, random_lines(method, 1u << 14, 0), 30, {1, 5, 9, 14}))
            CHECK(std::abs(b.mean - 2.0) < 4.0 * b.standard_error + 1e-6);
    }
}

TEST_CASE("a plate that sees nothing but the sky receives pi times its radiance on both sides")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {2, 0, 0}, builder.grey(0.5, 0.0));
    const Scene scene = under_sky(builder.file(), {8.0, 8.0, 8.0}, 10.0, true);
    for (const Method method : all_methods()) {
        CAPTURE(method->name);
        const Solution solution = solve(scene, random_lines(method, 1u << 16, 1), silent);
        CHECK(solution.radiosity[0].g == doctest::Approx(4.0).epsilon(0.02));
        CHECK(solution.radiosity[scene.first_patch(0, false)].g == doctest::Approx(4.0).epsilon(0.02));
        CHECK(solution.balance.behind.g == 0.0);
        // Half of 8 W/m^2 on 4 m^2. Gathering walks scale it by losses that have more noise.
        CHECK(solution.balance.absorbed.g == doctest::Approx(16.0).epsilon(0.2));
    }
}

// No surface of a convex body sees another, so B = rho E. Line reuse finds it with any number of lines and of patches.
TEST_CASE("convex bodies under a sky have B = rho E by line reuse, whatever the patches and lines")
{
    for (const bool two_sided : {false, true})
        for (const double patch_size : {10.0, 0.5, 0.1})
            for (const std::uint64_t lines : {50u, 3000u, 40000u}) {
                CAPTURE(two_sided);
                CAPTURE(patch_size);
                CAPTURE(lines);
                SceneBuilder builder;
                builder.triangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, builder.grey(0.7, 0.0));
                if (!two_sided)
                    builder.box({1e4, 0, 5}, {1e4 + 1, 2, 6}, builder.grey(0.4, 0.0)); // far away
                const Scene scene = under_sky(builder.file(), {10, 10, 10}, patch_size, two_sided);
                SolveOptions options = random_lines(Method::reuse, lines, 1);
                options.sequence = "sobol";
                const Solution solution = solve(scene, options, silent);
                for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
                    if (!scene.is_sky_patch(i))
                        CHECK(solution.radiosity[i].g ==
                              doctest::Approx(10.0 * scene.reflectance(i).g).epsilon(1e-3).scale(0.0));
            }
}

// What enters a black box through its open side is absorbed: E times the area of the opening.
TEST_CASE("an open box under a sky takes in E times its opening, with a table, counts or particles")
{
    for (const double patch_size : {1.0, 0.25, 0.0625})
        for (const std::uint64_t lines : {1u << 11, 1u << 14, 1u << 17}) {
            CAPTURE(patch_size);
            CAPTURE(lines);
            SceneBuilder builder;
            const std::uint32_t black = builder.grey(0.0, 0.0);
            builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, black).rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, black);
            builder.rectangle({1, 0, 0}, {0, 0, 1}, {0, 1, 0}, black).rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, black);
            builder.rectangle({0, 0, 1}, {0, 1, 0}, {1, 0, 0}, black);
            const Scene scene = under_sky(builder.file(), {10, 10, 10}, patch_size);
            SolveOptions options = random_lines(Method::reuse, lines, 1);
            options.sequence = "sobol-owen";
            const Solution solution = solve(scene, options, silent);
            // Rays of the walls find the opening with p = 1/5: the standard deviation of independent ones.
            const double deviation = std::sqrt(0.2 * 0.8 / (0.5 * static_cast<double>(lines))) / 0.2;
            CHECK(solution.balance.absorbed.g == doctest::Approx(10.0).epsilon(4.0 * deviation + 2e-3).scale(0.0));
            CHECK(solution.balance.escaped.g >= 0.0);
        }
}

// The sun in the zenith lights the floor alone, and this the wall: b_f = rho (E + F b_w), b_w = rho F b_f.
// Furniture that touches floor, walls and ceiling leaves lines from outside no hit that tells on which side of a wall
// they are. Some of it has the outline of a wall or of another piece.
TEST_CASE("a closed room under a sky is dark, whatever furniture stands against its walls")
{
    const std::vector<std::vector<std::array<Vec3, 2>>> furnishings = {
        {{Vec3{0, 0, 0}, {0.77, 0.8, 0.9}}},                        // in a corner
        {{Vec3{0, 1.7, 0}, {0.77, 2.6, 0.9}}},                      // below the ceiling, in a corner
        {{Vec3{1, 0, 4.96}, {1.9, 2.05, 5}}},                       // a door
        {{Vec3{0, 0, 1}, {0.5, 2.6, 2.2}}},                         // from floor to ceiling
        {{Vec3{0, 0, 4.5}, {4, 2.6, 5}}},                           // all of a wall
        {{Vec3{0, 0, 4.5}, {4, 1.2, 5}}},                           // along a wall
        {{Vec3{0, 0, 0}, {1, 1, 1}}, {Vec3{0, 1, 0}, {1, 2.6, 1}}}, // one on the other
        {{Vec3{0, 0, 0}, {1, 1, 1}}, {Vec3{1, 0, 0}, {2, 1, 1}}},   // side by side
        {{Vec3{0, 0, 0}, {1, 1, 1}}, {Vec3{1, 0, 0}, {4, 2.6, 1}}}, // filling the wall in two pieces
        {{Vec3{1.3, 0.9, 1.1}, {2.2, 1.4, 1.9}}, {Vec3{1.3, 0, 1.1}, {2.2, 0.9, 1.9}}}, // free, on the floor
    };
    for (std::size_t k = 0; k < furnishings.size(); ++k) {
        SceneBuilder builder;
        builder.room({0, 0, 0}, {4, 2.6, 5}, builder.grey(0.7, 0.0));
        const std::uint32_t wood = builder.grey(0.5, 0.0);
        for (const auto& [low, high] : furnishings[k])
            builder.box(low, high, wood);
        const Scene scene = under_sky(builder.file(), {10, 10, 10}, 0.5);
        for (const Method method : all_methods()) {
            CAPTURE(k);
            CAPTURE(method->name);
            const Solution solution = solve(scene, random_lines(method, 1u << 15, 1), silent);
            double inside = 0.0;
            for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
                inside += scene.is_sky_patch(i) ? 0.0 : mean(solution.radiosity[i]);
            CHECK(inside == 0.0);
        }
    }
}

TEST_CASE("the floor in the sun lights the wall" * doctest::test_suite("statistics"))
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, grey);
    builder.rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, grey);
    const Scene scene = builder.sun(sun_at(0, 90, {0, 1, 0}, {10, 10, 10})).scene(10.0);
    const double f = 0.2000437;
    const double b_floor = 0.5 * 10.0 / (1.0 - 0.25 * f * f);
    for (const Method method : all_methods()) {
        CAPTURE(method->name);
        const std::vector<Estimate> found = radiosities(scene, random_lines(method, 1u << 14, 0), 30, {0, 1});
        CHECK(found[0].mean == doctest::Approx(b_floor).epsilon(1e-3));
        const Estimate wall = found[1];
        CHECK(std::abs(wall.mean - 0.5 * f * b_floor) < 4.0 * wall.standard_error + 1e-6);
        const Solution solution = solve(scene, random_lines(method, 1u << 14, 1), silent);
        CHECK(solution.balance.source.g == doctest::Approx(10.0));
        CHECK(solution.balance.relative_error() < 1e-9);
    }
}

// A table of pairs that few lines tell would err by half of the light.
TEST_CASE("sunlight on many patches is right with few lines, too")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    builder.rectangle({0, 0, 0}, {0, 0, 4}, {4, 0, 0}, grey).box({1, 0, 1}, {2, 1, 2}, grey);
    const Scene scene = builder.sun(sun_at(20, 30, {0, 1, 0}, {10, 10, 10})).scene(0.1);
    const auto power = [&](std::uint64_t lines) {
        const Solution solution = solve(scene, random_lines(Method::reuse, lines, 1), silent);
        double sum = 0.0;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            sum += scene.area(i) * solution.radiosity[i].g;
        return sum;
    };
    const double right = power(1u << 18);
    for (const std::uint64_t lines : {1u << 10, 1u << 12, 1u << 13, 1u << 15})
        CHECK(power(lines) == doctest::Approx(right).epsilon(0.02));
}

// All that a plate in the open reflects of the sun escapes, and all that a lamp in a box sends meets the backs of its
// black faces.
TEST_CASE("reflected sunlight that escapes and lamplight lost behind surfaces are told apart")
{
    SceneBuilder builder;
    const Rgb rho = {0.8, 0.0, 0.3};
    builder.rectangle({-5, 2, 1}, {2, 0, 0}, {0, 3, 0}, builder.material(rho, {})); // looks along z
    builder.box({-4.5, 2.5, -2}, {-3.5, 3.5, -1}, builder.grey(0.0, 0.0));
    builder.rectangle({-4.2, 2.7, -1.8}, {0, 0.5, 0}, {0, 0, 0.6}, builder.material({0.1, 0.2, 0.6}, {0.0, 7.0, 5.0}));
    builder.sun({normalized({3, 0, 4}), {10.0, 20.0, 0.0}});
    const Scene scene = builder.scene(0.7);
    const Rgb escaped = 6.0 * 0.8 * Rgb{8.0, 0.0, 0.0};
    const Rgb behind = 0.3 * Rgb{0.0, 7.0, 5.0};
    for (const Method method : all_methods()) {
        CAPTURE(method->name);
        const PowerBalance balance = solve(scene, random_lines(method, 1u << 14, 3), silent).balance;
        if (balance.emitted_error > 0.0)
            continue; // global lines of a walk: by number, with noise
        for (double Rgb::*c : {&Rgb::r, &Rgb::g, &Rgb::b}) {
            CHECK(balance.escaped.*c == doctest::Approx(escaped.*c).epsilon(1e-9));
            CHECK(balance.behind.*c == doctest::Approx(behind.*c).epsilon(1e-9));
        }
    }
}

// A lamp, the sky and the sun together are their sum, since light does not disturb light.
TEST_CASE("lamp, sky and sun add up" * doctest::test_suite("statistics"))
{
    const auto scene = [](double lamp, double sky, double sun) {
        SceneBuilder builder;
        const std::uint32_t grey = builder.grey(0.6, 0.0);
        const std::uint32_t light = builder.grey(0.0, lamp);
        builder.rectangle({0, 0, 0}, {0, 0, 2}, {2, 0, 0}, grey).box({0.5, 0, 0.5}, {1, 1, 1}, grey);
        builder.rectangle({0, 2, 0}, {0.5, 0, 0}, {0, 0, 0.5}, light);
        if (sun > 0.0)
            builder.sun(sun_at(120, 40, {0, 1, 0}, {sun, sun, sun}));
        SceneFile file = builder.file();
        if (sky > 0.0)
            add_sky(file, {sky, sky, sky});
        return Scene(std::move(file), 0.5, false);
    };
    const auto floor_power = [](const Scene& lit, Method method) {
        return over_seeds(lit, random_lines(method, 1u << 14, 0), 30, [&lit](const Solution& s) {
            double power = 0.0;
            for (std::uint32_t i = 0; lit.surface_of(i) == 0; ++i)
                power += lit.area(i) * s.radiosity[i].g;
            return power;
        });
    };
    const double parts = floor_power(scene(5, 0, 0), Method::reuse).mean +
                         floor_power(scene(0, 3, 0), Method::reuse).mean +
                         floor_power(scene(0, 0, 4), Method::reuse).mean;
    for (const Method method : all_methods()) {
        CAPTURE(method->name);
        const Estimate all = floor_power(scene(5, 3, 4), method);
        CHECK(std::abs(all.mean - parts) < 4.0 * all.standard_error + 0.002 * parts);
    }
}

} // namespace daylight_methods_test
