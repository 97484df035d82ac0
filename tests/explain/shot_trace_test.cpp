#include "explain/stage_trace.h"

#include "base/errors.h"
#include "radiosity/paper/first_shot.h"
#include "radiosity/run/run.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

namespace shot_trace_test {

using namespace multipath;

namespace {

/// A room lit from a small lamp, open towards one side, so that some rays leave it.
Scene dim_room()
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.7, 0.0);
    const std::uint32_t red = builder.material({0.8, 0.3, 0.1}, {});
    const std::uint32_t lamp = builder.material({0.5, 0.5, 0.5}, {30.0, 20.0, 10.0});
    builder.rectangle({0, 0, 0}, {0, 0, 2}, {2, 0, 0}, grey);
    builder.rectangle({0, 1, 0}, {2, 0, 0}, {0, 0, 2}, red);
    builder.rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 2}, grey);
    builder.rectangle({0, 0, 0}, {2, 0, 0}, {0, 1, 0}, red);
    builder.rectangle({0.8, 0.7, 0.8}, {0, 0, 0.4}, {0.4, 0, 0}, lamp); // looks up
    return builder.scene(0.5);
}

SolveOptions run(Method method)
{
    SolveOptions options;
    options.method = method;
    options.lines = 4000;
    options.skip = 3;
    options.seed = 7;
    return options;
}

/// The state of the run after its first stage.
PowerState state_after(const Scene& scene, const SolveOptions& options, std::vector<ShotPass>& passes)
{
    Run solver(scene, options);
    shoot_first(solver);
    passes = solver.solution.shot_passes;
    return solver.state;
}

/// Tells every ray of every pass and compares the sum with what the run's first stage brought. Equal powers are added
/// here and multiplied there: 1e-12 is far above the rounding of some thousand additions.
void require_sum_of_the_run(const SolveOptions& options, std::size_t least_passes)
{
    const Scene scene = dim_room();
    std::vector<ShotPass> passes;
    const PowerState state = state_after(scene, options, passes);
    REQUIRE(passes.size() >= least_passes);
    std::vector<Rgb> incident(scene.patch_count());
    Rgb escaped;
    std::uint64_t item = options.skip;
    for (std::size_t pass = 0; pass < passes.size(); ++pass) {
        const StageTrace trace = trace_shot_pass(scene, options, {0, passes[pass].lines, pass});
        for (const TracedLine& ray : trace.lines) {
            CHECK(ray.origin.item == item++);
            const Transfer& transfer = ray.transfers.at(0);
            if (Segment::is_patch(transfer.to))
                incident[transfer.to] += transfer.sent();
            else if (transfer.to == Segment::outside)
                escaped += transfer.sent();
        }
    }
    CHECK(mean(state.escaped) > 0.0);
    CHECK(mean(escaped) == doctest::Approx(mean(state.escaped)).epsilon(1e-12));
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        CHECK(incident[i].r == doctest::Approx(state.incident[i].r).epsilon(1e-12));
        CHECK(incident[i].b == doctest::Approx(state.incident[i].b).epsilon(1e-12));
    }
}

} // namespace

TEST_CASE("the rays told of a first shot add up to what it distributes")
{
    require_sum_of_the_run(run(Method::first_shot), 1);
}

TEST_CASE("the rays told of all passes of an extended first shot add up to what it distributes")
{
    require_sum_of_the_run(run(Method::extended), 3);
    SolveOptions refined = run(Method::extended);
    refined.threshold = 0.0;
    require_sum_of_the_run(refined, 3);
    refined.most_steps = 2;
    require_sum_of_the_run(refined, 2);
    refined.most_steps = 1;
    require_sum_of_the_run(refined, 1);
}

TEST_CASE("the rays told of passes with a given power per ray add up to what they distribute")
{
    SolveOptions options = run(Method::extended);
    options.power_by_line = 0.01;
    options.lines = 1u << 20;
    require_sum_of_the_run(options, 3);
}

TEST_CASE("the unshot power told after the last ray of a pass is the solver's")
{
    const Scene scene = dim_room();
    const SolveOptions options = run(Method::first_shot);
    std::vector<ShotPass> passes;
    const PowerState state = state_after(scene, options, passes);
    std::vector<Rgb> unshot(scene.patch_count());
    for (const TracedLine& ray : trace_shot_pass(scene, options, {0, passes[0].lines}).lines)
        for (const Transfer& transfer : ray.transfers)
            if (Segment::is_patch(transfer.to))
                unshot[transfer.to] = transfer.then_held;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (mean(unshot[i]) > 0.0)
            CHECK(unshot[i].r == doctest::Approx(state.unshot[i].r).epsilon(1e-12)); // as above
}

TEST_CASE("a pass or a ray that the run does not have is refused, and so is a run without passes")
{
    const Scene scene = dim_room();
    const SolveOptions options = run(Method::first_shot);
    CHECK_THROWS_AS(trace_shot_pass(scene, options, {0, 1, 1}), InputError);
    CHECK_THROWS_AS(trace_shot_pass(scene, options, {options.lines, 1}), InputError);
    SolveOptions nothing = options;
    nothing.ratio = 0.0;
    CHECK_THROWS_AS(trace_shot_pass(scene, nothing, {0, 1}), InputError);
}

} // namespace shot_trace_test
