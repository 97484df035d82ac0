#include "radiosity/paper/extended_first_shot.h"

#include "radiosity/paper/line_budget.h"
#include "statistics.h"
#include "test_scenes.h"

#include <cmath>
#include <doctest/doctest.h>
#include <numeric>

namespace extended_first_shot_test {

using namespace multipath;

namespace {

Scene lit_room(double reflectance)
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(reflectance, 0.0);
    const std::uint32_t lamp = builder.grey(0.0, 10.0);
    builder.room({0, 0, 0}, {2, 2, 2}, wall).box({0.2, 0, 0.2}, {0.8, 1, 0.8}, wall);
    return builder.rectangle({0.8, 1.9, 0.8}, {0.4, 0, 0}, {0, 0, 0.4}, lamp).scene(0.25);
}

std::uint64_t lines_of(const std::vector<ShotPass>& passes)
{
    return std::accumulate(passes.begin(), passes.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const ShotPass& pass) { return sum + pass.lines; });
}

} // namespace

TEST_CASE("the extended first shot uses the lines that it was given, to 1 %")
{
    const auto sequence = make_sequence("random", 3);
    for (const double reflectance : {0.3, 0.8})
        for (const std::uint64_t lines : {5000ull, 50000ull, 500000ull})
            for (const double threshold_factor : {0.0, 0.3, 1.0}) {
                const Scene scene = lit_room(reflectance);
                PowerState state(scene);
                ExtendedShotOptions options;
                options.lines = lines;
                options.threshold = threshold_factor * threshold_radiosity(scene);
                const std::uint64_t used = lines_of(shoot_extended(scene, *sequence, 0, options, {2}, state));
                CAPTURE(reflectance);
                CAPTURE(threshold_factor);
                CAPTURE(used);
                CHECK(std::abs(static_cast<double>(used) / static_cast<double>(lines) - 1.0) < 0.01);
            }
}

// Every pass sends on the share rho of what arrived before: with threshold 0 the powers of the passes fall like rho^k.
TEST_CASE("progressive ray refinement shoots the reflected light of each pass in the next")
{
    const Scene scene = lit_room(0.5);
    PowerState state(scene);
    ExtendedShotOptions options;
    options.power_by_line = 1e-4;
    const std::vector<ShotPass> passes = shoot_extended(scene, *make_sequence("random", 1), 0, options, {1}, state);
    CHECK(passes.size() >= 5);
    for (std::size_t k = 1; k < 5; ++k)
        CHECK(passes[k].power / passes[k - 1].power ==
              doctest::Approx(0.5).epsilon(0.05)); // the lamp's face absorbs a little
    double unshot = 0.0;
    for (const Rgb u : state.unshot)
        unshot += std::abs(u.g);
    CHECK(unshot < 0.02 * scene.source_power().g); // less than a ray is left on most patches
    CHECK(power_balance(scene, state).relative_error() < 1e-12);
}

TEST_CASE("steps bound the passes, and a threshold above everything shoots nothing")
{
    const Scene scene = lit_room(0.5);
    ExtendedShotOptions options;
    options.power_by_line = 1e-3;
    options.most_steps = 2;
    PowerState state(scene);
    CHECK(shoot_extended(scene, *make_sequence("random", 1), 0, options, {1}, state).size() == 2);
    options.threshold = 1e9;
    PowerState untouched(scene);
    CHECK(shoot_extended(scene, *make_sequence("random", 1), 0, options, {1}, untouched).empty());
}

// Rays for the power W in all, each of p, carry W exactly. A patch then shoots what it deserves on the average over the
// rounding, but for the bias of dividing by a sum: both that sum and the patch's share of it are off by about a ray at
// most, which makes p^2 / W. The rounding of one patch has a standard deviation of half a ray at most.
TEST_CASE("rounding to whole rays keeps all power, and its bias is a small part of one ray")
{
    SceneBuilder builder;
    const std::uint32_t faint = builder.grey(0.5, 0.3);
    const std::uint32_t bright = builder.grey(0.5, 2.7);
    const Scene scene = builder.room({0, 0, 0}, {1, 1, 1}, {faint, bright, faint, bright, faint, faint}).scene(1.0);
    const PowerState state(scene);
    constexpr int offsets = 20000;
    for (const double power_by_line : {1.0, 0.5, 0.07}) {
        std::vector<double> shot(6, 0.0);
        for (std::uint64_t seed = 0; seed < offsets; ++seed) {
            double all = 0.0;
            for (const Shot& s : plan_shots(scene, state, 0.0, power_by_line, seed, 1)) {
                shot[s.patch] += static_cast<double>(s.rays) * s.power_per_ray.g / offsets;
                all += static_cast<double>(s.rays) * s.power_per_ray.g;
            }
            CHECK(all == doctest::Approx(6.6).epsilon(1e-12));
        }
        for (std::uint32_t i = 0; i < 6; ++i)
            CHECK(std::abs(shot[i] - scene.emittance(i).g) <=
                  power_by_line * power_by_line / 6.6 + 4.5 * 0.5 * power_by_line / std::sqrt(offsets));
    }
}

// A red and a green lamp, and one ray: of the green light it carries what it can, the rest stays where it is.
TEST_CASE("what rays of another colour cannot carry stays unshot")
{
    SceneBuilder builder;
    const std::uint32_t black = builder.grey(0.0, 0.0);
    const std::uint32_t red = builder.material({}, {4.0, 0.1, 0.0});
    const std::uint32_t green = builder.material({}, {0.1, 3.0, 0.0});
    const Scene scene = builder.room({0, 0, 0}, {1, 1, 1}, {red, green, black, black, black, black}).scene(1.0);
    PowerState state(scene);
    const std::vector<Shot> shots = plan_first_shot(scene, state, 0.0, 1, 1);
    REQUIRE(rays_of(shots).rays() == 1);
    const Rgb sent = shots[0].power_per_ray;
    spend(scene, 0.0, shots, state);
    CHECK(power_balance(scene, state).unshot.r + sent.r == doctest::Approx(4.1));
    CHECK(power_balance(scene, state).unshot.g + sent.g == doctest::Approx(3.1));
    CHECK(state.emitted.g == doctest::Approx(3.1));
    CHECK(state.unshot[0].r >= 0.0);
    CHECK(state.unshot[1].g >= 0.0);
}

// With so few rays most patches deserve a small part of one: the passes must still come to an end, and the light to its
// mean.
TEST_CASE("few rays and no threshold end after a few passes without bias")
{
    const Scene scene = lit_room(0.5);
    std::vector<double> incident;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        PowerState state(scene);
        ExtendedShotOptions options;
        options.lines = 500;
        options.seed = seed;
        CHECK(shoot_extended(scene, *make_sequence("random", seed), 0, options, {1}, state).size() < 100);
        double sum = 0.0;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            sum += state.incident[i].g;
        incident.push_back(sum / scene.source_power().g);
        CHECK(power_balance(scene, state).relative_error() < 1e-12);
    }
    // All light is reflected by 0.5 until it ends, but what meets the lamp's black face or back: 1 / (1 - 0.5) and a
    // little less.
    const double mean_incident = estimate(incident).mean;
    CHECK(mean_incident < 2.0 + 4.0 * estimate(incident).standard_error);
    CHECK(mean_incident > 1.9 - 4.0 * estimate(incident).standard_error);
}

} // namespace extended_first_shot_test
