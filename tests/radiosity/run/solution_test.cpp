#include "radiosity/run/solution.h"

#include "radiosity/run/run.h"
#include "seeded_runs.h"
#include "test_scenes.h"

#include <cmath>
#include <doctest/doctest.h>

namespace solution_test {

using namespace multipath;

namespace {

Rgb grey(double value)
{
    return {value, value, value};
}

Scene two_patches()
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, paint);
    builder.rectangle({0, 0, 1}, {0, 1, 0}, {3, 0, 0}, paint);
    return builder.scene(10.0);
}

/// As many lines, each patch of this radiosity with this standard error.
Solution part(std::uint64_t lines, double radiosity, double error)
{
    Solution solution;
    solution.radiosity = {grey(radiosity), grey(2.0 * radiosity)};
    solution.unshot = {grey(0.01 * radiosity), Rgb{}};
    solution.all_lines = lines;
    solution.global_lines = lines / 10;
    solution.global_lines_cast = lines / 4; // of which some miss the scene
    solution.local_lines = lines - solution.global_lines;
    solution.replicates = 4;
    solution.standard_error = {grey(error), grey(3.0 * error)};
    return solution;
}

} // namespace

// Of w1 = 1/4 and w2 = 3/4 the mean is w1 B1 + w2 B2 and its variance w1^2 e1^2 + w2^2 e2^2.
// Each of these stages is wrong in its own way: not solved, not finite, light from nowhere, an open balance.
TEST_CASE("where a method finds no sound solution, particles carry the light")
{
    MethodInfo info = *Method::reuse.operator->();
    info.prepare = nullptr;
    const Scene scene = coloured_room();
    for (const Stage stage : std::initializer_list<Stage>{
             [](Run& run) { throw NoSolution(run.scene.path()); },
             [](Run& run) { run.state.incident[0] = grey(std::nan("")); },
             [](Run& run) { run.state.emitted = 1.001 * run.state.emitted; },
             [](Run& run) { run.state.escaped = grey(1.0); },
         }) {
        info.stages = {stage};
        const SolveOptions options = random_lines(Method(&info), 10000, 3);
        const Solution found = solve(scene, options, silent);
        CHECK(found.by_particles);
        const Solution right = solve(scene, random_lines(Method::local, 10000, 3), silent);
        CHECK(!right.by_particles);
        CHECK(found.radiosity == right.radiosity);
    }
}

TEST_CASE("independent results are averaged by their lines, and so are the squares of their errors")
{
    const Scene scene = two_patches();
    REQUIRE(scene.patch_count() == 2);
    const Solution sum = combined(scene, {part(1000, 1.0, 0.4), part(3000, 5.0, 0.1)});
    const double error = std::sqrt(std::pow(0.25 * 0.4, 2) + std::pow(0.75 * 0.1, 2));
    CHECK(sum.radiosity[0].g == doctest::Approx(4.0));
    CHECK(sum.radiosity[1].g == doctest::Approx(8.0));
    CHECK(sum.unshot[0].g == doctest::Approx(0.04));
    REQUIRE(sum.standard_error.size() == 2);
    CHECK(sum.standard_error[0].r == doctest::Approx(error));
    CHECK(sum.standard_error[1].b == doctest::Approx(3.0 * error));
    CHECK(sum.all_lines == 4000);
    CHECK(sum.local_lines == 3600);
    CHECK(sum.global_lines == 400);
    CHECK(sum.global_lines_cast == 1000);
    // (1) with areas of 1 and 3: the mean square error over the square of the mean radiosity of 7.
    REQUIRE(sum.relative_standard_error.has_value());
    CHECK(*sum.relative_standard_error == doctest::Approx(std::sqrt((1.0 + 3.0 * 9.0) / 4.0) * error / 7.0));
}

TEST_CASE("one part without an error leaves the sum without")
{
    Solution without = part(1000, 1.0, 0.4);
    without.standard_error.clear();
    const Solution sum = combined(two_patches(), {without, part(3000, 5.0, 0.1)});
    CHECK(sum.standard_error.empty());
    CHECK_FALSE(sum.relative_standard_error.has_value());
    CHECK(sum.radiosity[0].r == doctest::Approx(4.0));
}

} // namespace solution_test
