#include "explain/stage_trace.h"

#include "base/errors.h"
#include "base/text_format.h"
#include "explain/words.h"
#include "radiosity/paper/local_monte_carlo.h"
#include "radiosity/run/solve.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

namespace particle_trace_test {

using namespace multipath;

namespace {

SolveOptions short_run(Estimator estimator)
{
    SolveOptions options;
    options.method = Method::local;
    options.lines = 3000;
    options.estimator = estimator;
    return options;
}

StageTrace tell_all(const Scene& scene, const SolveOptions& options)
{
    const std::uint64_t particles = trace_particles(scene, options, {0, 1}).count;
    return trace_particles(scene, options, {0, particles});
}

} // namespace

// The solver adds the same powers in two levels: 1e-12 is far above the rounding of some thousand additions.
TEST_CASE("the scores told for all particles add up to the solver's radiosity, their segments to its lines")
{
    const Scene scene = coloured_room();
    for (const Estimator estimator : {Estimator::collision, Estimator::absorption}) {
        const SolveOptions options = short_run(estimator);
        PowerState state(scene);
        std::uint64_t segments = 0;
        for (const TracedLine& particle : tell_all(scene, options).lines)
            for (const Transfer& told : particle.transfers) {
                ++segments;
                state.incident[told.to] += told.counted; // the room is closed
            }
        const Solution solution = solve(scene, options, [](double) {});
        CHECK(segments == solution.local_lines);
        const std::vector<Rgb> told = radiosity(scene, state);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            CHECK(told[i].r == doctest::Approx(solution.radiosity[i].r).epsilon(1e-12));
            CHECK(told[i].b == doctest::Approx(solution.radiosity[i].b).epsilon(1e-12));
        }
    }
}

TEST_CASE("a path goes from patch to patch as long as the number drawn is below the reflectance, and then ends")
{
    const Scene scene = coloured_room();
    const SolveOptions options = short_run(Estimator::collision);
    const Particles particles = plan_particles(scene, PowerState(scene), options.lines, options.seed, options.threads);
    const auto sequence = make_sequence(options.sequence, options.seed);
    for (const TracedLine& particle : tell_all(scene, options).lines) {
        ParticlePaths paths; // the solver's
        particles.follow(*sequence, 0, particle.origin.number, 1, paths);
        REQUIRE(paths.steps.size() == particle.transfers.size());
        REQUIRE(particle.notes.size() == particle.transfers.size());
        REQUIRE(particle.crossings.size() == particle.transfers.size());
        for (std::size_t k = 0; k < particle.transfers.size(); ++k) {
            const Transfer& told = particle.transfers[k];
            const std::string& note = particle.notes[k];
            const ParticleStep& step = paths.steps[k];
            const bool goes_on = step.drawn < mean(scene.reflectance(told.to));
            CHECK(goes_on == (k + 1 < particle.transfers.size()));
            CHECK(goes_on == (note.find("it goes on") != std::string::npos));
            CHECK(note.find(format("the number drawn, %.3f,", step.drawn)) != std::string::npos);
            CHECK(particle.crossings[k].patches.arrives_at == told.to);
            if (goes_on) {
                CHECK(particle.transfers[k + 1].from == told.to);
                CHECK(particle.transfers[k + 1].sent() == step.goes_on);
                CHECK(note.find("it goes on with " + watts(particle.transfers[k + 1].sent())) != std::string::npos);
            }
        }
    }
}

TEST_CASE("particles that the run does not have are refused")
{
    CHECK_THROWS_AS(trace_particles(coloured_room(), short_run(Estimator::collision), {100000, 1}), InputError);
}

} // namespace particle_trace_test
