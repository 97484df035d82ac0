#include "explain/line_trace.h"

#include "base/errors.h"
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

ParticleTrace tell_all(const Scene& scene, const SolveOptions& options)
{
    const std::uint64_t particles = trace_particles(scene, options, {0, 1}).particle_count;
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
        for (const TracedParticle& particle : tell_all(scene, options).particles)
            for (const TracedStep& told : particle.steps) {
                ++segments;
                state.incident[told.step.where] += told.counted; // the room is closed
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
    for (const TracedParticle& particle : tell_all(scene, short_run(Estimator::collision)).particles)
        for (std::size_t k = 0; k < particle.steps.size(); ++k) {
            const TracedStep& told = particle.steps[k];
            const bool goes_on = told.step.drawn < mean(scene.reflectance(told.step.where));
            CHECK(goes_on == (k + 1 < particle.steps.size()));
            REQUIRE(told.crossing);
            CHECK(told.crossing->patches.arrives_at == told.step.where);
            if (goes_on) {
                CHECK(particle.steps[k + 1].step.from == told.step.where);
                CHECK(particle.steps[k + 1].step.power == told.step.goes_on);
            }
        }
}

TEST_CASE("particles that the run does not have are refused")
{
    CHECK_THROWS_AS(trace_particles(coloured_room(), short_run(Estimator::collision), {100000, 1}), InputError);
}

} // namespace particle_trace_test
