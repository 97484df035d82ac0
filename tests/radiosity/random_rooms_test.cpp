// Closed rooms made at random, with white walls in parts, bodies that stand on the floor or on a lamp, and few lines:
// no method may make light or lose it, whichever way its result is found.

#include "radiosity/memory_estimate.h"
#include "radiosity/reuse/line_reuse.h"
#include "radiosity/solve.h"
#include "sampling/random.h"
#include "statistics.h"
#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <string>
#include <vector>

namespace random_rooms_test {

using namespace multipath;

namespace {

Scene random_room(std::uint64_t key)
{
    std::uint64_t counter = 0;
    const auto within = [&](double low, double high) {
        return low + (high - low) * bits_to_unit(random_bits(key, counter++));
    };
    SceneBuilder builder;
    const auto wall = [&] {
        const double kind = within(0.0, 1.0);
        if (kind < 0.3)
            return builder.grey(1.0, 0.0);
        if (kind < 0.4)
            return builder.grey(0.0, 0.0);
        return builder.material({within(0, 0.9), within(0, 0.9), within(0, 0.9)}, {});
    };
    const Vec3 size = {within(1, 4), within(1, 4), within(1, 4)};
    std::vector<std::uint32_t> walls = {wall(), wall(), wall(), wall(), wall(), builder.grey(0.5, 0.0)};
    const std::uint32_t lamp = builder.material({0.3, 0.2, 0.1}, {within(1, 9), within(1, 9), within(1, 9)});
    const bool floor_shines = within(0.0, 1.0) < 0.3;
    if (floor_shines)
        walls[0] = lamp;
    builder.room({0, 0, 0}, size, walls);
    const int boxes = static_cast<int>(within(0.0, 4.0));
    for (int k = 0; k < boxes; ++k) { // each in its own strip of the room, some on the floor
        const double x = (0.1 + 0.8 * k / boxes) * size.x;
        const double y = within(0.0, 1.0) < 0.5 ? 0.0 : within(0.05, 0.3) * size.y;
        const double z = within(0.1, 0.5) * size.z;
        builder.box({x, y, z},
                    {x + 0.7 * size.x / boxes * within(0.3, 1.0), y + within(0.1, 0.5) * size.y, z + 0.3 * size.z},
                    wall());
    }
    if (!floor_shines) {
        const Vec3 corner = {0.3 * size.x, within(0.85, 0.99) * size.y, 0.4 * size.z};
        builder.rectangle(corner, {0.3 * size.x, 0, 0}, {0, 0, 0.2 * size.z}, lamp); // shines down
        builder.rectangle(corner, {0, 0, 0.2 * size.z}, {0.3 * size.x, 0, 0}, builder.grey(0.5, 0.0));
    }
    return builder.scene(within(0.25, 0.6));
}

double mean_radiosity(const Scene& scene, const Solution& solution)
{
    double power = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        power += scene.area(i) * mean(solution.radiosity[i]);
    return power / scene.total_area();
}

struct Way
{
    std::string name;
    Method method;
    Direct direct;
    enum Memory { plenty, too_little_for_table, least } memory;
};

const std::vector<Way> ways = {
    {"local", Method::local, Direct::gather, Way::plenty},
    {"global", Method::global, Direct::gather, Way::plenty},
    {"first shot", Method::first_shot, Direct::gather, Way::plenty},
    {"extended", Method::extended, Direct::gather, Way::plenty},
    {"jacobi", Method::jacobi, Direct::gather, Way::plenty},
    {"transillumination", Method::transillumination, Direct::gather, Way::plenty},
    {"gathering", Method::gathering, Direct::gather, Way::plenty},
    {"table", Method::reuse, Direct::gather, Way::plenty},
    {"table after shots", Method::reuse, Direct::shoot, Way::plenty},
    {"counts", Method::reuse, Direct::gather, Way::too_little_for_table},
    {"counts after shots", Method::reuse, Direct::shoot, Way::too_little_for_table},
    {"counts with the least memory", Method::reuse, Direct::gather, Way::least},
};

SolveOptions options_of(const Scene& scene, const Way& way, std::uint64_t lines, std::uint64_t seed)
{
    SolveOptions options;
    options.method = way.method;
    options.direct = way.direct;
    options.sequence = "sobol-owen";
    options.lines = lines;
    options.seed = seed;
    options.threads = 2;
    if (way.memory != Way::plenty)
        options.memory = run_bytes(static_cast<double>(scene.surfaces().size()), scene.patch_count()) +
                         (way.memory == Way::least ? 0.0 : 0.999 * reuse_bytes(scene));
    return options;
}

bool forecasts(const Way& way)
{
    return way.method == Method::global || way.method == Method::first_shot || way.method == Method::extended;
}

struct MeanOfRuns
{
    Estimate radiosity; ///< [W/m^2] mean over the patches and over independent runs
    double unsent;      ///< [W/m^2] what the power that is not sent yet would add at most, were all patches white
};

MeanOfRuns mean_of_runs(const Scene& scene, const Way& way, std::uint64_t lines)
{
    std::vector<double> means;
    double unshot = 0.0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Solution solution = solve(scene, options_of(scene, way, lines, seed), [](double) {});
        means.push_back(mean_radiosity(scene, solution));
        unshot += 0.1 * mean(solution.balance.unshot);
    }
    const double absorption = 1.0 - mean(scene.average_reflectance());
    return {estimate(means), std::max(0.0, unshot) / (scene.total_area() * absorption)};
}

// In the rooms of keys first ... last: every method, however few the lines, gives finite light, neither made nor lost.
void check_that_light_stays(std::uint64_t first, std::uint64_t last)
{
    for (std::uint64_t key = first; key <= last; ++key) {
        CAPTURE(key);
        const Scene scene = random_room(key);
        for (const Way& way : ways)
            for (const std::uint64_t lines : {64u, 1024u, 16384u}) {
                CAPTURE(way.name);
                CAPTURE(lines);
                const Solution solution = solve(scene, options_of(scene, way, lines, key), [](double) {});
                for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
                    CHECK(std::isfinite(mean(solution.radiosity[i])));
                    CHECK(solution.radiosity[i].r >= scene.emittance(i).r);
                    CHECK(solution.radiosity[i].b >= scene.emittance(i).b);
                }
                const PowerBalance& balance = solution.balance;
                const double source = mean(scene.source_power());
                CHECK(balance.relative_error() < 1e-9);
                CHECK(std::abs(mean(balance.escaped)) <= 1e-9 * source);
                CHECK(std::abs(mean(balance.behind)) <= 1e-9 * source);
                if (forecasts(way))
                    CHECK(std::abs(mean(balance.emitted) - source) <= 5.0 * balance.emitted_error);
                else
                    CHECK(mean(balance.emitted) == doctest::Approx(source).epsilon(1e-6));
            }
    }
}

} // namespace

TEST_CASE("in random closed rooms every method gives finite light that is neither made nor lost, however few the lines")
{
    check_that_light_stays(1, 6);
}

TEST_CASE("in more random closed rooms light stays, too")
{
    check_that_light_stays(7, 24);
}

TEST_CASE("in random closed rooms the mean radiosity is that of particles, by every method" *
          doctest::test_suite("statistics"))
{
    for (std::uint64_t key = 1; key <= 3; ++key) {
        CAPTURE(key);
        const Scene scene = random_room(key);
        const Estimate truth = mean_of_runs(scene, ways[0], 1u << 18).radiosity;
        for (const Way& way : ways) {
            CAPTURE(way.name);
            const MeanOfRuns found = mean_of_runs(scene, way, 1u << 15);
            // The bias of parts of 24 rays for each patch (docs/line_reuse.md).
            const double bias =
                way.memory != Way::least ? 0.0 : 0.03 / (24.0 * (1.0 - mean(scene.average_reflectance()))) * truth.mean;
            const double noise = 5.0 * std::hypot(found.radiosity.standard_error, truth.standard_error) + bias;
            CHECK(found.radiosity.mean <= truth.mean + noise);
            CHECK(found.radiosity.mean >= truth.mean - noise - found.unsent);
        }
    }
}

} // namespace random_rooms_test
