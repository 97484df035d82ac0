#include "radiosity/reuse/balanced_reuse.h"

#include "geometry/polygon.h"
#include "radiosity/paper/shot_rays.h"
#include "statistics.h"
#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace gathered_light_test {

using namespace multipath;

namespace {

struct Gathered
{
    std::vector<Rgb> incident; ///< [W] per patch
    std::uint64_t lines;
    Rgb escaped; ///< [W]
    Rgb behind;
    PowerState state;
};

Gathered gathered(const Scene& scene, const Sequence& sequence, const BalancedRays& rays, int threads = 2)
{
    PowerState state(scene);
    const BalancedResult result = reuse_balanced(scene, SceneLights(scene, 2), sequence, rays, 1e9, {threads}, state);
    return {state.incident, result.rays, state.escaped, state.behind, state};
}

Gathered gathered(const Scene& scene, std::uint64_t rays, std::uint64_t seed = 1, const char* sequence = "random",
                  int threads = 2)
{
    return gathered(scene, *make_sequence(sequence, seed), {0, rays, true, false}, threads);
}

std::vector<Rgb> shot(const Scene& scene, std::uint64_t rays, std::uint64_t seed)
{
    PowerState state(scene);
    shoot(scene, *make_sequence("random", seed), 0, plan_first_shot(scene, state, 0.0, rays, 1), {2}, state);
    return state.incident;
}

/// [W] Received by all patches of a surface.
double received(const Scene& scene, const std::vector<Rgb>& incident, std::uint32_t surface)
{
    double sum = 0.0;
    const std::uint32_t first = scene.first_patch(surface);
    for (std::uint32_t i = first; i < first + scene.tessellation(surface).cell_count(); ++i)
        sum += incident[i].g;
    return sum;
}

/// Compares patch by patch and in all, over independent runs. Left out are patches that receive less than 1 mW: the few
/// rays that find the light there are far from a normal distribution.
void check_same_mean(const Scene& scene, std::uint64_t gathering_rays, std::uint64_t shooting_rays)
{
    constexpr std::uint64_t runs = 16;
    std::vector<std::vector<double>> difference(scene.patch_count());
    std::vector<double> total(runs);
    std::vector<double> received_by(scene.patch_count());
    for (std::uint64_t run = 0; run < runs; ++run) {
        const std::vector<Rgb> a = gathered(scene, gathering_rays, run).incident;
        const std::vector<Rgb> b = shot(scene, shooting_rays, 100 + run);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            difference[i].push_back(a[i].g - b[i].g);
            total[run] += difference[i].back();
            received_by[i] += b[i].g / runs;
        }
    }
    // The standard error of 16 runs is itself uncertain: by Student's t with 15 degrees of freedom, one of 700 patches
    // exceeds 7.5 of them once in a thousand tests.
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (received_by[i] > 1e-3)
            CHECK(estimate(difference[i]).agrees_with(0.0, 7.5));
    const Estimate all = estimate(total);
    CHECK((all.agrees_with(0.0, 4.0) || std::abs(all.mean) < 1e-9 * scene.source_power().g));
}

/// A room with a lamp below the ceiling, in a tight frame that rises above it, and a box on the floor. The frame stands
/// in the light of its own lamp, a hundredth of a patch away from it.
SceneBuilder framed_lamp()
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    const std::uint32_t lamp = builder.grey(0.1, 10.0);
    builder.room({0, 0, 0}, {2, 2, 2}, grey);
    builder.box({0.4, 0.0, 0.6}, {0.9, 0.7, 1.1}, grey);
    builder.rectangle({0.8, 1.5, 0.8}, {0, 0, 0.4}, {0.4, 0, 0}, lamp); // shines up
    builder.rectangle({0.8, 1.5, 0.8}, {0.4, 0, 0}, {0, 0, 0.4}, grey); // its lower side
    builder.box({0.75, 1.45, 0.75}, {0.798, 1.6, 1.25}, grey);          // frame, on both sides
    return builder.box({1.202, 1.45, 0.75}, {1.25, 1.6, 1.25}, grey);
}

constexpr double pi = 3.14159265358979323846;

/// Form factor of opposite unit squares at distance 1, from the textbooks.
double opposite_squares()
{
    const double root = std::sqrt(2.0);
    return 2.0 / pi * (0.5 * std::log(4.0 / 3.0) + 2.0 * root * std::atan(1.0 / root) - 2.0 * std::atan(1.0));
}

/// Form factor of unit squares with a common edge, at a right angle.
double adjoining_squares()
{
    const double root = std::sqrt(2.0);
    return 1.0 / pi * (2.0 * std::atan(1.0) - root * std::atan(1.0 / root) + 0.25 * std::log(0.75));
}

} // namespace

// Gauss points on 10 x 10 patches; near the common edge the light bends most.
TEST_CASE("a cube lit by its ceiling receives the textbook's form factors and, in all, what is emitted")
{
    SceneBuilder builder;
    const std::uint32_t dark = builder.grey(0.0, 0.0);
    builder.room({0, 0, 0}, {1, 1, 1}, {dark, builder.grey(0.0, 2.0), dark, dark, dark, dark});
    for (const double patch_size : {0.1, 1.0}) {
        CAPTURE(patch_size);
        const Scene scene = builder.scene(patch_size);
        const Gathered light = gathered(scene, 2 * scene.patch_count());
        CHECK(received(scene, light.incident, 0) == doctest::Approx(2.0 * opposite_squares()).epsilon(1e-6));
        for (std::uint32_t wall = 2; wall < 6; ++wall)
            CHECK(received(scene, light.incident, wall) == doctest::Approx(2.0 * adjoining_squares()).epsilon(1e-5));
        CHECK(std::abs(light.escaped.g) < 2e-5);
        CHECK(light.behind == Rgb{});
    }
}

// The lamp touches two walls along its edges. Nothing is hidden, so single rays must do, and no patch may stand out:
// the oracle is the irradiance at 40 x 40 points of each patch, whose error is of the order of a cell's share, 1/1600.
TEST_CASE("a lamp in the corner of the ceiling lights the walls that it touches without outliers")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    builder.room({0, 0, 0}, {1, 1, 1}, grey);
    builder.rectangle({0, 1, 0}, {0.25, 0, 0}, {0, 0, 0.25}, builder.grey(0.0, 1.0)); // on the ceiling, on top of it
    const Scene scene = builder.scene(0.1);
    const Gathered light = gathered(scene, 4 * scene.patch_count());
    const Surface lamp = scene.surfaces().back();
    for (std::uint32_t i = 0; i < scene.first_patch(6); ++i) {
        const Surface shape = scene.patch(i).shape;
        const FlatPolygon seen = part_above_horizon(lamp, shape.origin, shape.normal());
        double sum = 0.0;
        for (int k = 0; k < 1600; ++k)
            sum += irradiance_from(seen, shape.at((k / 40 + 0.5) / 40.0, (k % 40 + 0.5) / 40.0), shape.normal());
        CHECK(light.incident[i].g == doctest::Approx(scene.area(i) * sum / 1600.0).epsilon(2e-3));
    }
    CHECK(std::abs(light.escaped.g) < 1e-5 * scene.source_power().g);
}

// A floor that shines with 2 W/m^2, a box of 1 x 1 on it: its bottom gets the 2 W of the lamp under it, and the closed
// room the rest.
TEST_CASE("a body that stands on a lamp gets the light under it")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    builder.room({0, 0, 0}, {3, 2, 3}, {builder.grey(0.5, 2.0), grey, grey, grey, grey, grey});
    builder.box({1.1, 0, 0.8}, {2.1, 0.7, 1.8}, grey);
    const Scene scene = builder.scene(0.3);
    for (const std::uint64_t rays : {4 * std::uint64_t{scene.patch_count()}, std::uint64_t{1} << 15}) {
        const Gathered light = gathered(scene, rays);
        double bottom = 0.0;
        double all = 0.0;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const Surface shape = scene.patch(i).shape;
            all += light.incident[i].g;
            if (shape.normal().y < -0.5 && std::abs(shape.centre().y) < 1e-9)
                bottom += light.incident[i].g;
        }
        CHECK(bottom == doctest::Approx(2.0).epsilon(0.02)); // all light received is scaled to the light sent
        CHECK(all == doctest::Approx(18.0).epsilon(1e-9));
        CHECK(light.escaped == Rgb{});
    }
}

// Two unit squares at distance 1: the share of the textbook arrives, the rest escapes.
TEST_CASE("gathered light that leaves the scene is told as escaped, and nothing is lost")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, builder.grey(0.0, 3.0)); // looks up
    builder.rectangle({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.5, 0.0)); // looks down
    const Scene scene = builder.scene(0.1);
    const Gathered light = gathered(scene, 1u << 14);
    CHECK(received(scene, light.incident, 1) == doctest::Approx(3.0 * opposite_squares()).epsilon(1e-4));
    CHECK(light.escaped.g == doctest::Approx(3.0 * (1.0 - opposite_squares())).epsilon(1e-4));
    CHECK(light.behind == Rgb{});
    CHECK(power_balance(scene, light.state).relative_error() < 1e-12);
    CHECK(light.state.emitted.g == doctest::Approx(3.0).epsilon(1e-12));
    CHECK(power_balance(scene, light.state).unshot.g == doctest::Approx(1.5 * opposite_squares()).epsilon(1e-4));
}

TEST_CASE("behind obstacles, gathering gives what shooting gives" * doctest::test_suite("statistics"))
{
    const Scene scene = framed_lamp().scene(0.2);
    check_same_mean(scene, 1u << 16, 1u << 18);
}

// Clusters of lights are right to about 3 %, which many rays of a patch correct and few do not. Allowed is one percent
// of what a surface receives.
TEST_CASE("with few rays for each patch gathering is right to a percent on the average" *
          doctest::test_suite("statistics"))
{
    SceneBuilder builder = framed_lamp();
    const std::uint32_t lamp = builder.grey(0.1, 3.0);
    for (int k = 0; k < 8; ++k)
        builder.rectangle({0.2 + 0.2 * k, 1.9, 1.7}, {0.1, 0, 0}, {0, 0, 0.1}, lamp);
    const Scene scene = builder.scene(0.2);
    const auto surfaces = static_cast<std::uint32_t>(scene.surfaces().size());
    constexpr std::uint64_t many = 1u << 22;
    const std::vector<Rgb> truth = shot(scene, many, 1);
    const double power_per_ray = scene.source_power().g / many;
    for (const std::uint32_t rays_per_patch : {16u, 8u, 2u}) {
        CAPTURE(rays_per_patch);
        std::vector<std::vector<double>> samples(surfaces);
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            const Gathered light = gathered(scene, rays_per_patch * scene.patch_count(), seed);
            for (std::uint32_t s = 0; s < surfaces; ++s)
                samples[s].push_back(received(scene, light.incident, s));
        }
        for (std::uint32_t s = 0; s < surfaces; ++s) {
            const double expected = received(scene, truth, s);
            const double bias = 0.01 * expected;
            Estimate found = estimate(samples[s]);
            found.standard_error = std::hypot(found.standard_error, std::sqrt(expected * power_per_ray));
            CAPTURE(s);
            CHECK(std::abs(found.mean - expected) <= 4.0 * found.standard_error + bias);
        }
    }
}

// Backs receive, but only fronts emit: a sheet in the middle of a room, its front bright. The room's own patches all
// look inwards, so that what the sheet emits arrives.
TEST_CASE("of a two-sided scene only fronts emit")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    builder.room({0, 0, 0}, {1, 1, 1}, grey);
    builder.rectangle({0.3, 0.5, 0.3}, {0, 0, 0.4}, {0.4, 0, 0}, builder.grey(0.5, 1.0)); // shines up
    const Scene scene = builder.scene(0.1, true);
    const Gathered light = gathered(scene, 1u << 14);
    CHECK(received(scene, light.incident, 0) == 0.0); // the floor
    CHECK(received(scene, light.incident, 1) > 0.5 * scene.source_power().g);
    CHECK(std::abs(light.escaped.g) < 1e-4 * scene.source_power().g);

    SceneBuilder turned; // the same room inside out: its backs receive the same
    turned.box({0, 0, 0}, {1, 1, 1}, turned.grey(0.5, 0.0));
    turned.rectangle({0.3, 0.5, 0.3}, {0, 0, 0.4}, {0.4, 0, 0}, turned.grey(0.5, 1.0));
    CHECK(std::abs(gathered(turned.scene(0.1, true), 1u << 14).escaped.g) < 1e-4 * scene.source_power().g);
    const Gathered lost = gathered(turned.scene(0.1), 1u << 14); // no patch looks at the sheet
    CHECK(lost.behind.g == doctest::Approx(scene.source_power().g));
    CHECK(lost.escaped.g == 0.0);
}

// A lamp that is larger than the patches, a tiny one in front of a wall, and a row of small ones. Nothing hides them,
// so that no noise is left but that of clusters of lights, which err by 3 %.
TEST_CASE("the backs of a room that is turned inside out receive what the fronts of the other do")
{
    for (const double patch_size : {0.25, 3.0}) {
        std::vector<double> of_room;
        for (const bool is_turned : {false, true}) {
            SceneBuilder builder;
            const std::uint32_t grey = builder.grey(0.5, 0.0);
            if (is_turned)
                builder.box({-2, 1, 0}, {-1, 2, 1.5}, grey);
            else
                builder.room({-2, 1, 0}, {-1, 2, 1.5}, grey);
            builder.rectangle({-1.7, 1.5, 0.6}, {0, 0, 0.4}, {0.4, 0, 0}, builder.grey(0.5, 1.0));    // shines up
            builder.rectangle({-1.02, 1.3, 0.4}, {0, 0.01, 0}, {0, 0, 0.02}, builder.grey(0.5, 5e3)); // along x
            for (int k = 0; k < 8; ++k)
                builder.rectangle({-1.9 + 0.1 * k, 1.8, 0.1}, {0.02, 0, 0}, {0, 0.02, 0}, builder.grey(0.5, 100.0));
            const Scene scene = builder.scene(patch_size, true);
            const std::vector<Rgb> incident = gathered(scene, 1u << 14).incident;
            for (std::uint32_t wall = 0; wall < 6; ++wall) {
                double sum = 0.0;
                const std::uint32_t first = scene.first_patch(wall, !is_turned);
                for (std::uint32_t i = first; i < first + scene.tessellation(wall).cell_count(); ++i)
                    sum += incident[i].g;
                if (is_turned)
                    CHECK(sum == doctest::Approx(of_room[wall]).epsilon(0.1).scale(0.0));
                else
                    of_room.push_back(sum);
            }
        }
    }
}

TEST_CASE("gathered light is the same for any number of threads")
{
    const Scene scene = framed_lamp().scene(0.1);
    for (const std::uint64_t rays : {std::uint64_t{1} << 17, 4 * std::uint64_t{scene.patch_count()}}) {
        const Gathered one = gathered(scene, rays, 1, "sobol", 1);
        CHECK(one.lines <= rays + 6); // of three rounds, each rounded twice
        CHECK(one.lines + 6 >= rays);
        for (const int threads : {2, 7}) {
            const Gathered many = gathered(scene, rays, 1, "sobol", threads);
            CHECK(many.incident == one.incident);
            CHECK(many.escaped == one.escaped);
            CHECK(many.lines == one.lines);
        }
    }
}

// Measured: 60 to 140 times where obstacles stand far from the light, 7 where they stand in it, as this frame does.
TEST_CASE("gathering is several times more precise than shooting as many rays" * doctest::test_suite("statistics"))
{
    const Scene scene = framed_lamp().scene(0.1);
    const std::vector<Rgb> truth = gathered(scene, 1u << 21, 99, "sobol-owen").incident;
    const auto error = [&](const std::vector<Rgb>& incident) {
        double sum = 0.0;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            sum += std::pow(incident[i].g - truth[i].g, 2) / scene.area(i);
        return sum;
    };
    CHECK(error(shot(scene, 1u << 16, 1)) > 5.0 * error(gathered(scene, 1u << 16).incident));
}

namespace {

/// Random numbers that remember which items were taken for rays; offsets of systematic samples come one by one.
class WatchedSequence final : public Sequence
{
public:
    std::string name() const override { return "watched"; }
    int dimensions() const override { return random_->dimensions(); }
    std::uint64_t item_limit() const override { return random_->item_limit(); }
    double coordinate(std::uint64_t n, int dimension) const override { return random_->coordinate(n, dimension); }
    void generate(std::uint64_t first, std::vector<Item>& items) const override
    {
        for (std::uint64_t k = 0; k < items.size(); ++k)
            taken_.push_back(first + k);
        random_->generate(first, items);
    }
    const std::vector<std::uint64_t>& taken() const { return taken_; }

private:
    std::unique_ptr<Sequence> random_ = make_sequence("random", 1);
    mutable std::vector<std::uint64_t> taken_;
};

} // namespace

// Rays that share their numbers would err to the same side.
TEST_CASE("every shadow ray takes an item of its own")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    builder.room({0, 0, 0}, {1, 1, 1}, grey).box({0.3, 0.2, 0.3}, {0.7, 0.5, 0.7}, grey);
    builder.rectangle({0.2, 0.99, 0.2}, {0.1, 0, 0}, {0, 0, 0.1}, builder.grey(0.5, 1.0));
    builder.rectangle({0.7, 0.99, 0.7}, {0.1, 0, 0}, {0, 0, 0.1}, builder.grey(0.5, 1.0));
    const Scene scene = builder.scene(0.1);
    const WatchedSequence sequence;
    constexpr std::uint64_t first = 1000;
    constexpr std::uint64_t rays = 20000;
    const Gathered light = gathered(scene, sequence, {first, rays, true, false}, 1);
    std::vector<std::uint64_t> taken = sequence.taken();
    std::sort(taken.begin(), taken.end());
    REQUIRE(taken.size() > rays / 2);
    CHECK(std::adjacent_find(taken.begin(), taken.end()) == taken.end());
    CHECK(taken.front() >= first);
    CHECK(taken.back() < first + rays);
    CHECK(light.lines == taken.size());
}

} // namespace gathered_light_test
