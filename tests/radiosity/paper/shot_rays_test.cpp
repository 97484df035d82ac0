#include "radiosity/paper/shot_rays.h"

#include "form_factor.h"
#include "irregular_scene.h"
#include "test_scenes.h"
#include "transport/lines/line_segments.h"
#include "transport/lines/local_rays.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace shot_rays_test {

using namespace multipath;

namespace {

/// A room whose ceiling (9 patches) emits 4 W/m^2 and whose floor (9 patches) emits 1 W/m^2.
Scene two_lamps()
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 0.0);
    const std::uint32_t bright = builder.grey(0.5, 4.0);
    const std::uint32_t faint = builder.grey(0.5, 1.0);
    return builder.room({0, 0, 0}, {3, 3, 3}, {faint, bright, wall, wall, wall, wall}).scene(1.0);
}

} // namespace

TEST_CASE("every source shoots what exceeds the threshold, in rays of nearly equal power")
{
    const Scene scene = two_lamps();
    const PowerState state(scene);
    const std::vector<Shot> shots = plan_first_shot(scene, state, 0.4, 1000, 1);
    CHECK(shots.size() == 18);
    std::uint64_t rays = 0;
    for (const Shot& shot : shots) {
        rays += shot.rays;
        const double excess = mean(scene.emittance(shot.patch)) - 0.4; // area 1
        CHECK(static_cast<double>(shot.rays) * shot.power_per_ray.g == doctest::Approx(excess));
        const double power_by_line = 9 * (3.6 + 0.6) / 1000;
        CHECK(static_cast<double>(shot.rays) ==
              doctest::Approx(excess / power_by_line).epsilon(1.01 * power_by_line / excess));
    }
    CHECK(rays == 1000);
}

TEST_CASE("sources below the threshold keep their power")
{
    const Scene scene = two_lamps();
    CHECK(plan_first_shot(scene, PowerState(scene), 1.0, 100, 1).size() == 9);
    CHECK(plan_first_shot(scene, PowerState(scene), 4.0, 100, 1).empty());
    CHECK(plan_first_shot(scene, PowerState(scene), 0.0, 0, 1).empty());
}

// With a fixed rounding, the same sources would get no ray whatever the seed.
TEST_CASE("with fewer rays than sources every source shoots its power on the average over the seeds")
{
    const Scene scene = two_lamps();
    const PowerState state(scene);
    constexpr std::uint64_t seeds = 4000;
    const auto mean_shot = [&](std::uint64_t rays, double threshold) {
        std::vector<double> shot(scene.patch_count(), 0.0);
        for (std::uint64_t seed = 0; seed < seeds; ++seed)
            for (const Shot& s : plan_first_shot(scene, state, threshold, rays, seed))
                shot[s.patch] += static_cast<double>(s.rays) * s.power_per_ray.g / seeds;
        return shot;
    };
    for (const std::uint64_t rays : {1, 3, 7, 12})
        for (const double threshold : {0.0, 0.5}) {
            CAPTURE(rays);
            CAPTURE(threshold);
            const std::vector<double> shot = mean_shot(rays, threshold);
            for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
                const double excess = std::max(0.0, scene.emittance(i).g - threshold);
                const double power_by_line = power_above(scene, state, threshold) / static_cast<double>(rays);
                CHECK(std::abs(shot[i] - excess) <= 4.0 * std::sqrt(excess * power_by_line / seeds)); // binomial
            }
        }
}

TEST_CASE("where every source is worth a ray, the shots are those of any seed")
{
    const Scene scene = two_lamps();
    const PowerState state(scene);
    const std::vector<Shot> one = plan_first_shot(scene, state, 0.0, 100, 1);
    const std::vector<Shot> other = plan_first_shot(scene, state, 0.0, 100, 2);
    REQUIRE(one.size() == other.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
        CHECK(one[k].patch == other[k].patch);
        CHECK(one[k].rays == other[k].rays);
    }
}

TEST_CASE("what a patch keeps of its unshot power is the threshold, and no rounding error above it")
{
    const Scene scene = two_lamps();
    for (const double threshold : {0.0, 0.1, 0.3, 0.7, 0.9, 1.3, 2.9}) {
        PowerState state(scene);
        spend(scene, threshold, plan_first_shot(scene, state, threshold, 1000, 1), state);
        CHECK(power_above(scene, state, threshold) == 0.0);
    }
}

TEST_CASE("shooting moves power and loses none")
{
    const Scene scene = two_lamps();
    PowerState state(scene);
    const auto sequence = make_sequence("random", 1);
    const std::vector<Shot> shots = plan_first_shot(scene, state, 0.0, 20000, 1);
    spend(scene, 0.0, shots, state);
    shoot(scene, *sequence, 0, shots, {2}, state);
    double incident = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        incident += state.incident[i].g;
        CHECK(state.unshot[i].g == doctest::Approx(0.5 * state.incident[i].g)); // its own emission is gone
    }
    CHECK(incident == doctest::Approx(9 * 5.0)); // closed: all of it arrives
    CHECK(power_balance(scene, state).relative_error() < 1e-12);
}

// Sums of numbers of ten bits are the same in any order, to the last bit.
TEST_CASE("with the colours exchanged the same rays carry the same power, exchanged")
{
    const auto turned = [](Rgb c) { return Rgb{c.b, c.r, c.g}; };
    const Scene scene = irregular_scene();
    PowerState state(scene);
    std::uint64_t counter = 0;
    const auto number = [&] { return std::floor(0x1p10 * bits_to_unit(random_bits(1, counter++))); };
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        state.unshot[i] = {number(), i % 3 == 0 ? 0.0 : number(), i % 2 == 0 ? 0.0 : 4.0 * number()};
    for (const double share : {0.0, 0.5, 1.5})
        for (const std::uint64_t rays : {7u, 1000u}) {
            CAPTURE(share);
            CAPTURE(rays);
            const double threshold = share * 1024.0 / scene.own_area() * scene.patch_count();
            PowerState before = state;
            PowerState other = state;
            for (Rgb& unshot : other.unshot)
                unshot = turned(unshot);
            const std::vector<Shot> shots = plan_first_shot(scene, before, threshold, rays, 1);
            const std::vector<Shot> again = plan_first_shot(scene, other, threshold, rays, 1);
            REQUIRE(shots.size() > 1);
            REQUIRE(again.size() == shots.size());
            for (std::size_t k = 0; k < shots.size(); ++k) {
                CHECK(again[k].patch == shots[k].patch);
                CHECK(again[k].rays == shots[k].rays);
                CHECK(again[k].power_per_ray == turned(shots[k].power_per_ray));
            }
            spend(scene, threshold, shots, before);
            spend(scene, threshold, again, other);
            for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
                CHECK(other.unshot[i] == turned(before.unshot[i]));
        }
}

// In a black cube whose floor emits 1 W the ceiling receives F of two facing squares, each wall a quarter of the rest.
// Counts of rays are binomial at most: 4 standard deviations of 2^16 of them.
TEST_CASE("the first shot lights the ceiling of a cube with F and its walls with a quarter of the rest")
{
    SceneBuilder builder;
    const std::uint32_t black = builder.grey(0.0, 0.0);
    const std::uint32_t lamp = builder.grey(0.0, 1.0);
    const Scene scene = builder.room({0, 0, 0}, {1, 1, 1}, {lamp, black, black, black, black, black}).scene(1.0);
    const double f = opposite_form_factor();
    constexpr std::uint64_t rays = 1 << 16;
    for (const char* sequence : {"random", "sobol-owen", "halton"}) {
        CAPTURE(sequence);
        PowerState state(scene);
        const std::vector<Shot> shots = plan_first_shot(scene, state, 0.0, rays, 1);
        spend(scene, 0.0, shots, state);
        shoot(scene, *make_sequence(sequence, 1), 0, shots, {1}, state);
        CHECK(std::abs(state.incident[1].g - f) < 4.0 * std::sqrt(f * (1.0 - f) / rays));
        for (const std::uint32_t wall : {2u, 3u, 4u, 5u})
            CHECK(std::abs(state.incident[wall].g - 0.25 * (1.0 - f)) < 4.0 * std::sqrt(f * (1.0 - f) / rays));
    }
}

// Sobol's item 0 is a corner of the patch: there and everywhere else a ray starts on the patch and goes to its front.
TEST_CASE("rays start on their patch and leave through its front")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {0, 0, 2}, {1, 0, 0}, wall).triangle({0, 1, 0}, {1, 1, 0}, {0, 1, 1}, wall);
    const Scene scene = builder.scene(10.0);
    for (std::uint64_t n = 0; n < 1000; ++n) {
        const Item item = make_sequence("sobol", 0)->item(n);
        const Line up = local_line(scene.patch(0), item);
        CHECK((up.origin.x > 0 && up.origin.x < 1 && up.origin.z > 0 && up.origin.z < 2 && up.direction.y >= 0));
        const Line down = local_line(scene.patch(1), item);
        CHECK((down.origin.x > 0 && down.origin.z > 0 && down.origin.x + down.origin.z < 1 && down.direction.y <= 0));
        CHECK(length(up.direction) == doctest::Approx(1.0));
    }
}

// A ray that starts where a box covers the floor ends on the box's bottom, at once; one from a thin sheet passes its
// other face.
TEST_CASE("a covered floor lights only what covers it")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 1.0);
    builder.room({0, 0, 0}, {1, 1, 1}, wall).box({0.25, 0, 0.25}, {0.75, 0.5, 0.75}, wall);
    builder.rectangle({0.25, 0.7, 0.25}, {0.5, 0, 0}, {0, 0, 0.5}, wall); // faces down
    builder.rectangle({0.25, 0.7, 0.25}, {0, 0, 0.5}, {0.5, 0, 0}, wall); // faces up
    const Scene scene = builder.scene(1.0);
    const auto reached = [&](std::uint32_t surface, Vec3 from, Vec3 direction) {
        return receiver(scene, surface, {from, direction});
    };
    CHECK(reached(0, {0.5, 0, 0.5}, {0.1, 1, 0.2}) == 6);  // floor, covered: the bottom
    CHECK(reached(6, {0.5, 0, 0.5}, {0.1, -1, 0.2}) == 0); // and back
    CHECK(reached(0, {0.1, 0, 0.5}, {0, 1, 0}) == 1);      // floor, free: the ceiling
    CHECK(reached(13, {0.5, 0.7, 0.5}, {0, 1, 0}) == 1);   // the sheet's upper face: the ceiling, not the lower face
    CHECK(reached(12, {0.5, 0.7, 0.5}, {0, -1, 0}) == 7);  // its lower face: the top of the box
    CHECK(reached(7, {0.5, 0.5, 0.5}, {0, 1, 0}) ==
          12); // from the box's top: the sheet's lower face, which looks at it
}

} // namespace shot_rays_test
