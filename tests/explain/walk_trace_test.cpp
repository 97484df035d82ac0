#include "explain/stage_trace.h"

#include "base/errors.h"
#include "radiosity/family/gathering_walk.h"
#include "radiosity/run/solve.h"
#include "test_scenes.h"
#include "transport/lines/local_rays.h"

#include <doctest/doctest.h>

namespace walk_trace_test {

using namespace multipath;

namespace {

/// Fewer lines than two rounds take.
SolveOptions short_run(Estimator estimator)
{
    SolveOptions options;
    options.method = Method::gathering;
    options.lines = 3000;
    options.estimator = estimator;
    return options;
}

StageTrace trace_all(const Scene& scene, const SolveOptions& options)
{
    return trace_walks(scene, options, {0, trace_walks(scene, options, {0, 1}).count});
}

} // namespace

// The solver adds the same numbers in another order: 1e-12 is far above the rounding of some thousand additions.
TEST_CASE("what the traced walks add is the solver's irradiance, and their segments are its lines")
{
    const Scene scene = coloured_room();
    for (const Estimator estimator : {Estimator::collision, Estimator::absorption}) {
        const SolveOptions options = short_run(estimator);
        std::vector<Rgb> irradiance(scene.patch_count());
        std::uint64_t segments = 0;
        for (const TracedLine& walk : trace_all(scene, options).lines) {
            segments += walk.notes.size();
            for (const Transfer& transfer : walk.transfers)
                irradiance[transfer.to] += (1.0 / scene.area(transfer.to)) * transfer.counted;
        }
        const Solution solution = solve(scene, options, [](double) {});
        CHECK(segments == solution.local_lines);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const Rgb expected = scene.emittance(i) + scene.reflectance(i) * irradiance[i];
            CHECK(expected.r == doctest::Approx(solution.radiosity[i].r).epsilon(1e-12));
            CHECK(expected.b == doctest::Approx(solution.radiosity[i].b).epsilon(1e-12));
        }
    }
}

TEST_CASE("a walk adds light only where it meets a source, and starts with its own item")
{
    const Scene scene = coloured_room();
    const SolveOptions options = short_run(Estimator::collision);
    const Run run(scene, options);
    const Particles walks = first_walks(run);
    std::size_t adding = 0;
    for (const TracedLine& walk : trace_all(scene, options).lines) {
        CHECK(walk.origin.item == walk.origin.number);
        ParticlePaths paths; // the solver's
        walks.follow(*run.sequence, 0, walk.origin.number, 1, paths);
        CHECK(paths.steps.front().item == walk.origin.numbers);
        std::size_t on_source = 0;
        for (const Crossing& crossing : walk.crossings) // the room is closed
            on_source += scene.emittance(crossing.patches.arrives_at).r > 0.0 ? 1 : 0;
        CHECK(walk.transfers.size() == on_source);
        for (const Transfer& transfer : walk.transfers) {
            CHECK(scene.emittance(transfer.from).r > 0.0);
            CHECK(walk.points.front() == local_line(scene.patch(transfer.to), walk.origin.numbers).origin);
        }
        adding += on_source;
    }
    CHECK(adding > 100);
}

TEST_CASE("walks beyond the round are refused")
{
    const Scene scene = coloured_room();
    const SolveOptions options = short_run(Estimator::collision);
    const std::uint64_t walks = trace_walks(scene, options, {0, 1}).count;
    CHECK_NOTHROW(trace_walks(scene, options, {walks - 1, 1}));
    CHECK_THROWS_AS(trace_walks(scene, options, {walks, 1}), SettingsError);
}

} // namespace walk_trace_test
