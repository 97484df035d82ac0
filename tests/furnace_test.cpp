// Where all that emits and reflects is alike every patch has the same light, whatever the shape: any loss shows, above
// all where solids touch. "Within 4 standard errors": see laws_test.cpp.

#include "radiosity/paper/shot_rays.h"
#include "seeded_runs.h"
#include "test_scenes.h"

#include <array>
#include <doctest/doctest.h>

namespace furnace_test {

using namespace multipath;

// A closed box whose walls all have emittance E and reflectance rho: every reflection returns the share rho of the
// light, so B = E (1 + rho + rho^2 + ...) = E / (1 - rho) everywhere, whatever the shape of the box.
TEST_CASE("in a closed box of uniform walls the radiosity is E / (1 - rho)" * doctest::test_suite("statistics"))
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.3, 1.4);
    builder.room({0, 0, 0}, {1, 2, 3}, wall).box({0.3, 0.5, 0.4}, {0.6, 0.9, 1.0}, wall);
    const Scene scene = builder.scene(1.0);
    for (const Method method : all_methods())
        for (const Estimate& b :
             radiosities(scene, random_lines(method, 1u << 14, 0), 60, {0, 7, scene.patch_count() - 1}))
            CHECK(b.agrees_with(2.0));
}

// The same with boxes standing exactly on the floor, bottoms included, and a sheet made of two coincident faces: the
// furnace has no gaps, so the law holds on covered patches too. Wrong order of coincident hits shows here at once.
TEST_CASE("the furnace law holds with coincident faces" * doctest::test_suite("statistics"))
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.3, 1.4); // below 0.5, so that the threshold (4) leaves something to shoot
    builder.room({0, 0, 0}, {1, 1, 1}, wall).box({0.2, 0.0, 0.2}, {0.5, 0.3, 0.5}, wall);
    builder.rectangle({0.6, 0.5, 0.6}, {0.3, 0, 0}, {0, 0, 0.3}, wall); // faces down
    builder.rectangle({0.6, 0.5, 0.6}, {0, 0, 0.3}, {0.3, 0, 0}, wall); // faces up
    const Scene scene = builder.scene(0.5);
    for (const Method method : {Method::global, Method::first_shot})
        for (const Estimate& b : radiosities(scene, random_lines(method, 1u << 15, 0), 24,
                                             {0, scene.first_patch(6), scene.first_patch(12), scene.first_patch(13)}))
            CHECK(b.agrees_with(2.0));
    const Solution solution = solve(scene, random_lines(Method::first_shot, 1u << 16, 5), silent);
    CHECK(solution.balance.behind.g == 0.0);
    CHECK(solution.balance.escaped.g == 0.0);
}

// Light does not know how a room is turned, where it stands or in which unit it is measured. In this furnace boxes
// stand on the floor, on each other, in a corner and against a wall, and a sheet lies on one of them: after a rotation
// all the planes that touch differ by rounding. Every patch has B = 2 in expectation, whatever the motion.
TEST_CASE("the furnace law holds for touching solids under any rigid motion and scale")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.3, 1.4); // below 0.5, so that the threshold (4) leaves something to shoot
    builder.room({0, 0, 0}, {1, 1, 1}, wall).box({0.2, 0.0, 0.2}, {0.5, 0.3, 0.5}, wall);
    builder.box({0.2, 0.3, 0.2}, {0.5, 0.5, 0.5}, wall);                // on the first, with the same footprint
    builder.box({0.6, 0.0, 0.6}, {1.0, 0.4, 1.0}, wall);                // in a corner
    builder.rectangle({0.6, 0.4, 0.6}, {0.3, 0, 0}, {0, 0, 0.3}, wall); // a sheet on it: its lower face,
    builder.rectangle({0.6, 0.4, 0.6}, {0, 0, 0.3}, {0.3, 0, 0}, wall); // and its upper one
    const SceneFile file = builder.file();
    std::vector<std::vector<double>> samples(file.surfaces.size());
    for (std::uint64_t key = 1; key <= 40; ++key) {
        const RigidMotion motion(key);
        const Scene scene(motion.moved(file), 10.0 * motion.scale());
        const Method method = key % 2 == 0 ? Method::global : Method::first_shot;
        const Solution solution = solve(scene, random_lines(method, 1u << 14, key), silent);
        CAPTURE(key);
        CHECK((solution.local_lines > 1000) == (method == Method::first_shot));
        CHECK(solution.balance.escaped.g == 0.0);
        CHECK(solution.balance.behind.g == 0.0);
        for (std::size_t i = 0; i < samples.size(); ++i)
            samples[i].push_back(solution.radiosity[i].g);
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
        CAPTURE(i);
        CHECK(estimate(samples[i]).agrees_with(2.0));
    }
}

// Every patch of a closed scene that shoots all its light at B = 1 receives H = 1: sum_j F_ij = 1, with rays alone.
// Here every way of touching appears: floor to ceiling, in corners, side by side, one on the other, a table on legs, a
// sheet on a box.
TEST_CASE("in a closed scene of equal radiosity every patch receives that radiosity, also where solids touch")
{
    SceneBuilder builder;
    const std::uint32_t black = builder.grey(0.0, 1.0);
    builder.room({0, 0, 0}, {1, 1, 1}, black);
    builder.box({0.0, 0.0, 0.0}, {0.2, 0.3, 0.2}, black); // in a corner
    builder.box({0.4, 0.0, 0.4}, {0.5, 1.0, 0.5}, black); // a pillar from floor to ceiling
    builder.box({0.6, 0.0, 0.1}, {0.7, 0.3, 0.3}, black); // two side by side
    builder.box({0.7, 0.0, 0.1}, {0.8, 0.3, 0.3}, black);
    builder.box({0.6, 0.3, 0.1}, {0.8, 0.4, 0.3}, black);    // and one on both
    builder.box({0.65, 0.0, 0.65}, {0.7, 0.4, 0.7}, black);  // a leg
    builder.box({0.85, 0.0, 0.85}, {0.9, 0.4, 0.9}, black);  // another
    builder.box({0.6, 0.4, 0.6}, {0.95, 0.45, 0.95}, black); // a table top on them
    builder.box({0.1, 0.9, 0.6}, {0.3, 1.0, 0.8}, black);    // a lamp at the ceiling
    for (std::uint64_t key = 1; key <= 6; ++key) {
        const RigidMotion motion(key);
        const Scene scene(motion.moved(builder.file()), 10.0 * motion.scale());
        PowerState state(scene);
        const auto sequence = make_sequence("random", key);
        const std::vector<Shot> shots = plan_first_shot(scene, state, 0.0, 200000, 1);
        spend(scene, 0.0, shots, state);
        shoot(scene, *sequence, 0, shots, {2}, state);
        CHECK(state.escaped.g == 0.0);
        CHECK(state.behind.g == 0.0);
        const double power_per_ray = scene.source_power().g / 200000;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            CAPTURE(i);
            const double rays =
                scene.area(i) / power_per_ray; // a Poisson variable at most: closer, since shots are stratified
            CHECK(std::abs(state.incident[i].g / power_per_ray - rays) < 5.0 * std::sqrt(rays));
        }
    }
}

} // namespace furnace_test
