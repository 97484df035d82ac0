#include "explain/stage_trace.h"

#include "base/errors.h"
#include "radiosity/family/stochastic_jacobi.h"
#include "test_scenes.h"

#include <doctest/doctest.h>
#include <map>

namespace iteration_trace_test {

using namespace multipath;

namespace {

SolveOptions run(bool bidirectional)
{
    SolveOptions options;
    options.method = Method::jacobi;
    options.lines = 1u << 14;
    options.bidirectional = bidirectional;
    return options;
}

StageTrace trace_all(const Scene& scene, const SolveOptions& options)
{
    return trace_iteration(scene, options, {0, trace_iteration(scene, options, {0, 1}).count});
}

} // namespace

// With few lines left there is one iteration, whose mean with the series is weighted by lines.
TEST_CASE("the traced rays of the first iteration carry what the solver adds")
{
    const Scene scene = coloured_room();
    for (const bool bidirectional : {true, false}) {
        SolveOptions options = run(bidirectional);
        Run solver(scene, options);
        ray_series(solver);
        const std::uint64_t before = solver.solution.local_lines;
        const std::uint64_t lines = before + before / 2; // of the only iteration
        options.lines = before + lines;
        const PowerState series = solver.state;
        const std::uint64_t count = trace_first_iteration(solver, 0, 1).ray_count;
        const IterationTrace trace = trace_first_iteration(solver, 0, count);
        REQUIRE(trace.rays.size() == count);
        std::vector<Rgb> incident(scene.patch_count()); // the room is closed
        for (const IterationRay& ray : trace.rays) {
            incident[ray.to] += ray.sent;
            incident[ray.from] += ray.returned;
        }
        ray_iterations(solver);
        CHECK(solver.solution.local_lines == before + count);
        const PowerState& state = solver.state;
        const double weight = static_cast<double>(lines) / static_cast<double>(before + lines);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const Rgb expected = (1.0 - weight) * series.incident[i] + weight * incident[i];
            CHECK(expected.r == doctest::Approx(state.incident[i].r).epsilon(1e-12));
            CHECK(expected.b == doctest::Approx(state.incident[i].b).epsilon(1e-12));
        }
    }
}

TEST_CASE("rays of an iteration leave the patches in order, in proportion to what they carry together")
{
    const Scene scene = coloured_room();
    const StageTrace trace = trace_all(scene, run(false));
    std::map<std::uint32_t, std::pair<double, double>> sent; // rays and power of each patch
    std::uint32_t last = 0;
    for (const TracedLine& ray : trace.lines) {
        REQUIRE(ray.crossings.size() == 1);
        REQUIRE(ray.transfers.size() == 1);
        const Transfer& transfer = ray.transfers[0];
        CHECK(ray.crossings[0].patches.arrives_at == transfer.to);
        CHECK(transfer.from >= last);
        last = transfer.from;
        sent[last].first += 1.0;
        sent[last].second += mean(transfer.sent());
    }
    double power = 0.0;
    for (const auto& patch : sent)
        power += patch.second.second;
    // The rays are planned by the power, but for half of them at most, which go by area.
    for (const auto& patch : sent)
        CHECK(patch.second.first / static_cast<double>(trace.count) + 2.0 / static_cast<double>(trace.count) >
              0.5 * patch.second.second / power);
}

TEST_CASE("rays between two patches carry the same, whichever they leave")
{
    const Scene scene = coloured_room();
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<Rgb, Rgb>> carried;
    std::size_t met_again = 0;
    for (const TracedLine& ray : trace_all(scene, run(true)).lines) {
        REQUIRE(ray.transfers.size() == 2);
        const Transfer& there = ray.transfers[0];
        const Transfer& back = ray.transfers[1];
        const bool turned = there.from > there.to;
        const auto pair = turned ? std::pair{there.to, there.from} : std::pair{there.from, there.to};
        const auto power = turned ? std::pair{back.sent(), there.sent()} : std::pair{there.sent(), back.sent()};
        const auto [place, is_new] = carried.insert({pair, power});
        met_again += is_new ? 0 : 1;
        CHECK(place->second.first.g == doctest::Approx(power.first.g).epsilon(1e-14));
        CHECK(place->second.second.g == doctest::Approx(power.second.g).epsilon(1e-14));
    }
    CHECK(met_again > 100);
}

TEST_CASE("rays beyond the iteration are refused")
{
    const Scene scene = coloured_room();
    const std::uint64_t rays = trace_iteration(scene, run(true), {0, 1}).count;
    CHECK_NOTHROW(trace_iteration(scene, run(true), {rays - 1, 1}));
    CHECK_THROWS_AS(trace_iteration(scene, run(true), {rays, 1}), SettingsError);
}

} // namespace iteration_trace_test
