#include "base/errors.h"
#include "doctest/doctest.h"
#include "paused_work.h"
#include "radiosity/run/memory_estimate.h"
#include "radiosity/run/replicates.h"
#include "scene/daylight.h"
#include "test_scenes.h"

#include <string>
#include <vector>

namespace resume_test {

using namespace multipath;

namespace {

const auto silent = [](double) {};

/// A room with two lamps, a box, and a hole in one wall.
Scene room()
{
    SceneBuilder builder;
    const std::uint32_t red = builder.material({0.7, 0.3, 0.2}, {});
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    const std::uint32_t lamp = builder.material({0.2, 0.2, 0.2}, {8, 6, 4});
    builder.room({0, 0, 0}, {2, 2, 2}, {grey, grey, red, grey, grey, grey});
    builder.box({0.5, 0.2, 0.6}, {1.1, 0.9, 1.2}, red);
    builder.rectangle({0.2, 1.9, 0.2}, {0.3, 0, 0}, {0, 0, 0.3}, lamp);
    builder.rectangle({1.5, 1.8, 1.4}, {0.3, 0, 0}, {0, 0, 0.3}, lamp);
    return builder.scene(0.25);
}

bool same(const Solution& a, const Solution& b)
{
    return a.radiosity == b.radiosity && a.unshot == b.unshot && a.standard_error == b.standard_error &&
           a.all_lines == b.all_lines && a.global_lines_cast == b.global_lines_cast &&
           a.shot_passes.size() == b.shot_passes.size() && a.balance.emitted == b.balance.emitted &&
           a.balance.escaped == b.balance.escaped;
}

SolveOptions options_of(Method method, const std::string& sequence, std::uint64_t lines)
{
    SolveOptions options;
    options.method = method;
    options.sequence = sequence;
    options.lines = lines;
    options.threads = 1; // a pause at every block would start threads anew each time
    return options;
}

Solution solved(const Scene& scene, const SolveOptions& options, int replicates, Checkpoint* checkpoint)
{
    return solve_incrementally(scene, options, replicates, silent, checkpoint, {});
}

/// Leaves the work at every `step`-th pause, takes it up again, and compares; returns the number of pauses.
int check_all_pauses(const Scene& scene, const SolveOptions& options, int replicates, int step)
{
    const Solution whole = solved(scene, options, replicates, nullptr);
    int pause = 0;
    for (;; pause += step) {
        CAPTURE(pause);
        TestCheckpoint left(pause);
        solved(scene, options, replicates, &left);
        if (left.finished())
            break;
        TestCheckpoint resumed(-1, left.saved());
        CHECK(same(solved(scene, options, replicates, &resumed), whole));
        CHECK(resumed.finished());
    }
    return pause;
}

} // namespace

TEST_CASE("work that was left at any moment and taken up again gives the same bits")
{
    const Scene scene = room();
    for (const Method method : all_methods()) {
        for (const char* sequence : {"random", "sobol", "halton-permuted"}) {
            CAPTURE(method->name);
            CAPTURE(sequence);
            CHECK(check_all_pauses(scene, options_of(method, sequence, 40000), 1, method == Method::reuse ? 101 : 7) >=
                  6);
        }
    }
}

TEST_CASE("the variants of line reuse are taken up again, too")
{
    const Scene scene = room();
    SolveOptions options = options_of(Method::reuse, "sobol", 40000);
    SUBCASE("direct light that is shot")
    {
        options.direct = Direct::shoot;
    }
    const double all_else = run_bytes(static_cast<double>(scene.surfaces().size()), scene.patch_count());
    SUBCASE("counts of the pairs that are joined only")
    {
        options.memory = all_else + 1200.0 * scene.patch_count();
    }
    SUBCASE("counts that do not fit and are solved in rounds")
    {
        options.memory = all_else + 300.0 * scene.patch_count();
        options.lines = 600000;
    }
    SUBCASE("particles, as the lines are too few to be counted")
    {
        options.memory = 1e3;
    }
    SUBCASE("few rays, so that the lights are shot")
    {
        options.lines = 6000;
    }
    CHECK(check_all_pauses(scene, options, 1, options.lines > 100000 ? 61 : 47) >= 3);
}

TEST_CASE("rays for important patches, iterations one way, and bundles of some lines are taken up again")
{
    const Scene scene = room();
    SolveOptions options = options_of(Method::jacobi, "sobol", 40000);
    SUBCASE("rays for some patches")
    {
        Importance importance{std::vector<double>(scene.patch_count(), 0.0)};
        importance.weight[7] = importance.weight[100] = 1.0;
        options.method = Method::reuse;
        options.importance = std::make_shared<const Importance>(importance);
    }
    SUBCASE("rays one way")
    {
        options.bidirectional = false;
    }
    SUBCASE("bundles")
    {
        options.method = Method::transillumination;
        options.bundle = 3;
    }
    CHECK(check_all_pauses(scene, options, 1, options.importance ? 101 : 3) >= 6);
}

TEST_CASE("replicates and rounds are taken up again")
{
    const Scene scene = room();
    CHECK(check_all_pauses(scene, options_of(Method::extended, "sobol", 90000), 3, 31) > 40);
    CHECK(check_all_pauses(scene, options_of(Method::reuse, "random", 60000), 3, 199) > 400);

    const SolveOptions options = options_of(Method::reuse, "sobol", 0);
    const auto until = [&](Checkpoint* checkpoint) {
        const auto doubled = [](const Round& round) { return round.lines < 32000 ? 2 * round.lines : 0; };
        return solve_in_rounds(scene, options, 2, 4000, doubled, silent, checkpoint);
    };
    const Solution whole = until(nullptr);
    for (int pause = 0;; pause += 397) {
        TestCheckpoint left(pause);
        until(&left);
        if (left.finished())
            break;
        TestCheckpoint resumed(-1, left.saved());
        CHECK(same(until(&resumed), whole));
    }
}

TEST_CASE("work is left twice, with other numbers of threads")
{
    const Scene scene = room();
    SolveOptions options = options_of(Method::extended, "sobol", 60000);
    const Solution whole = solved(scene, options, 1, nullptr);
    TestCheckpoint first(3);
    options.threads = 1;
    solved(scene, options, 1, &first);
    REQUIRE(!first.finished());
    TestCheckpoint second(4, first.saved());
    options.threads = 3;
    solved(scene, options, 1, &second);
    REQUIRE(!second.finished());
    TestCheckpoint last(-1, second.saved());
    CHECK(same(solved(scene, options, 1, &last), whole));
}

TEST_CASE("a finished run goes on to more lines, also when that is interrupted")
{
    const Scene scene = room();
    for (const Method method : all_methods()) {
        TestCheckpoint first(-1);
        const Solution few = solved(scene, options_of(method, "sobol", 20000), 1, &first);
        REQUIRE(first.finished());
        TestCheckpoint more(-1, first.saved());
        const Solution many = solved(scene, options_of(method, "sobol", 60000), 1, &more);
        CHECK(many.all_lines == doctest::Approx(60000).epsilon(0.02));
        CHECK(!(many.radiosity == few.radiosity));
        CHECK(many.balance.relative_error() < 1e-9);

        TestCheckpoint left(4, first.saved());
        CHECK(same(solved(scene, options_of(method, "sobol", 60000), 1, &left), few)); // as of then
        TestCheckpoint resumed(-1, left.saved());
        CHECK(same(solved(scene, options_of(method, "sobol", 60000), 1, &resumed), many));

        TestCheckpoint fewer(-1, more.saved());
        CHECK_THROWS(solved(scene, options_of(method, "sobol", 30000), 1, &fewer));
    }
}

TEST_CASE("what is found when the work is left keeps the balance of power, and comes nearer to the result")
{
    const Scene scene = room();
    for (const Method method : all_methods()) {
        CAPTURE(method->name);
        const SolveOptions options = options_of(method, "sobol", 100000);
        const Solution whole = solved(scene, options, 1, nullptr);
        int pause = 0;
        for (;; pause += 9) {
            TestCheckpoint left(pause);
            const Solution then = solved(scene, options, 1, &left);
            if (left.finished())
                break;
            CHECK(then.balance.relative_error() < 1e-9);
            CHECK(then.all_lines <= whole.all_lines + (1u << 18)); // to send on what was not sent
            CHECK(mean(then.balance.absorbed) == doctest::Approx(mean(whole.balance.absorbed)).epsilon(0.3));
        }
        TestCheckpoint late(pause - 9);
        const Solution almost = solved(scene, options, 1, &late);
        CHECK(mean(almost.balance.absorbed) == doctest::Approx(mean(whole.balance.absorbed)).epsilon(0.1));
    }
}

TEST_CASE(
    "what patches have not sent on adds up to the balance's part, whatever the number of replicates that are done")
{
    const Scene scene = room();
    const SolveOptions options = options_of(Method::global, "sobol", 30000);
    int finished_parts = 0;
    for (int pause = 0;; pause += 3) {
        TestCheckpoint left(pause);
        const Solution then = solved(scene, options, 4, &left);
        Rgb unshot;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            unshot += scene.area(i) * then.unshot[i];
        for (double Rgb::*c : {&Rgb::r, &Rgb::g, &Rgb::b})
            CHECK(unshot.*c == doctest::Approx(then.balance.unshot.*c).epsilon(1e-9));
        if (left.finished())
            break;
        finished_parts += then.replicates > 1 ? 1 : 0;
    }
    CHECK(finished_parts > 0);
}

// Gathering walks ask patch after patch: what is left must not be a scene of which one half is dark.
TEST_CASE("gathering walks that are left have asked all patches alike, or say that nothing is distributed")
{
    const Scene scene = room();
    const SolveOptions options = options_of(Method::gathering, "sobol", 1u << 19);
    const Solution whole = solved(scene, options, 1, nullptr);
    const auto mean_of_half = [&](const Solution& solution, std::uint32_t half) {
        const std::uint32_t middle = scene.patch_count() / 2;
        double sum = 0.0;
        for (std::uint32_t i = half * middle; i < (half + 1) * middle; ++i)
            sum += scene.area(i) * mean(solution.radiosity[i] - scene.emittance(i));
        return sum;
    };
    int told = 0;
    for (int pause = 1;; pause += 13) {
        CAPTURE(pause);
        TestCheckpoint left(pause);
        const Solution then = solved(scene, options, 1, &left);
        if (left.finished())
            break;
        if (mean(then.balance.unshot) > 0.5 * mean(then.balance.emitted))
            continue;
        for (const std::uint32_t half : {0u, 1u})
            CHECK(mean_of_half(then, half) == doctest::Approx(mean_of_half(whole, half)).epsilon(0.3));
        ++told;
    }
    CHECK(told > 10);
}

// Every walk from the floor gathers the sky's emittance of 1. Particles, which carry the light until the first round of
// walks is done, have some noise.
TEST_CASE("what sees the sky alone keeps its light wherever gathering walks are left")
{
    SceneBuilder builder;
    SceneFile file = builder.rectangle({0, 0, 0}, {0, 0, 10}, {10, 0, 0}, builder.grey(0.5, 0.0)).file();
    add_sky(file, {1, 1, 1});
    const Scene scene(file, 100.0);
    const SolveOptions options = options_of(Method::gathering, "sobol", 1u << 18);
    for (int pause = 1;; pause += 5) {
        CAPTURE(pause);
        TestCheckpoint left(pause);
        const Solution then = solved(scene, options, 1, &left);
        if (!(mean(then.balance.unshot) > 0.5 * mean(then.balance.emitted)))
            CHECK(then.radiosity[0].g == doctest::Approx(0.5).epsilon(0.01));
        if (left.finished())
            break;
    }
}

TEST_CASE("state of other work is refused")
{
    const Scene scene = room();
    TestCheckpoint left(2);
    solved(scene, options_of(Method::extended, "sobol", 40000), 1, &left);
    TestCheckpoint other(-1, left.saved());
    CHECK_THROWS_AS(solved(scene, options_of(Method::local, "sobol", 40000), 1, &other), ArchiveError);
}

// Line reuse without a table of pairs solves for the lines that it has: however many they are, all of the light arrives
// somewhere. Only their noise is left, here below a hundredth.
TEST_CASE("line counts that are left stand for the lines that are missing")
{
    const Scene scene = room();
    SolveOptions options = options_of(Method::reuse, "sobol", 200000);
    options.memory = 1e3; // in rounds
    for (const Direct direct : {Direct::gather, Direct::shoot}) {
        CAPTURE(static_cast<int>(direct));
        options.direct = direct;
        const Solution whole = solved(scene, options, 1, nullptr);
        int counting = 0;
        for (int pause = 0;; pause += 17) {
            TestCheckpoint left(pause);
            const Solution then = solved(scene, options, 1, &left);
            if (left.finished())
                break;
            if (then.global_lines_cast == 0)
                continue; // the first light is not yet there
            CAPTURE(pause);
            ++counting;
            CHECK(mean(then.balance.absorbed) ==
                  doctest::Approx(mean(whole.balance.absorbed)).epsilon(0.01).scale(0.0));
            CHECK(mean(then.balance.unshot) < 0.01 * mean(whole.balance.emitted));
        }
        CHECK(counting > 3);
    }
}

// Where the light of the lamps is gathered, what no patch receives leaves the scene; but not what was not yet looked
// for. Between facing squares, B_1 = E + rho_1 F B_2 and B_2 = rho_2 F B_1; they absorb what does not escape.
TEST_CASE("light that was not yet found when the work was left has not escaped")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, builder.grey(0.4, 2.0));
    builder.rectangle({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.7, 0.0));
    const Scene scene = builder.scene(0.1);
    SolveOptions options = options_of(Method::reuse, "sobol", 200000);
    options.memory = 1.0;
    options.direct = Direct::gather;
    const double f = 0.19982489569838746; // Howell, C-11, for opposite sides of a cube
    const double b_1 = 2.0 / (1.0 - 0.4 * 0.7 * f * f);
    const double escaped = (1.0 - f) * (b_1 + 0.7 * f * b_1);
    TestCheckpoint left(0);
    const Solution then = solved(scene, options, 1, &left);
    REQUIRE(!left.finished());
    CHECK(then.balance.escaped.g == doctest::Approx(escaped).epsilon(0.01).scale(0.0));
    CHECK(then.balance.absorbed.g == doctest::Approx(2.0 - escaped).epsilon(0.05).scale(0.0));
}

// In a closed room of one reflectance the number of a particle's steps depends on its random decisions alone: the same
// decisions would make as many steps again.
TEST_CASE("a run that goes on to more lines draws other random numbers")
{
    SceneBuilder builder;
    const Scene scene = builder.room({0, 0, 0}, {1, 1, 1}, builder.grey(0.8, 1.0)).scene(0.5);
    for (const char* sequence : {"random", "sobol"}) {
        CAPTURE(sequence);
        TestCheckpoint first(-1);
        const Solution few = solved(scene, options_of(Method::local, sequence, 10000), 1, &first);
        TestCheckpoint more(-1, first.saved());
        const Solution many = solved(scene, options_of(Method::local, sequence, 20000), 1, &more);
        CHECK(many.local_lines != 2 * few.local_lines);
    }
}

} // namespace resume_test
