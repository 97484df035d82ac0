// Standard errors without a reference: independent randomisations of the same run tell how far their mean may be from
// the truth.

#include "radiosity/run/replicates.h"

#include "irregular_scene.h"
#include "paused_work.h"
#include "radiosity/reuse/denoising.h"
#include "scene/daylight.h"
#include "scene/obj/obj_reader.h"
#include "test_scenes.h"
#include "transport/lines/global_lines.h"

#include <cmath>
#include <doctest/doctest.h>
#include <stdexcept>

namespace replicates_test {

using namespace multipath;

namespace {

const ProgressCallback silent = [](double) {};

SolveOptions options_of(Method method, const std::string& sequence, std::uint64_t lines)
{
    SolveOptions options;
    options.method = method;
    options.sequence = sequence;
    options.lines = lines;
    options.threads = 2;
    options.ratio = method == Method::reuse || method == Method::local ? std::nullopt : std::optional<double>(1.0);
    return options;
}

Scene uneven_cube()
{
    SceneBuilder builder;
    std::vector<std::uint32_t> walls;
    for (const double rho : {0.2, 0.7, 0.5, 0.3, 0.8, 0.6})
        walls.push_back(builder.grey(rho, rho == 0.7 ? 3.0 : 0.0));
    return builder.room({0, 0, 0}, {1, 1, 1}, walls).scene(0.34);
}

/// The share of patches whose radiosity in the reference lies within `width` standard errors of the replicates' mean,
/// over several seeds.
double coverage(const Scene& scene, SolveOptions options, int replicates, double width, const std::vector<Rgb>& truth)
{
    const Preparation preparation = prepare(scene, options);
    double covered = 0.0;
    double all = 0.0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        options.seed = seed;
        const Solution s = solve_replicates(scene, preparation, options, replicates, silent);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            covered += std::abs(s.radiosity[i].g - truth[i].g) <= width * s.standard_error[i].g ? 1.0 : 0.0;
            all += 1.0;
        }
    }
    return covered / all;
}

} // namespace

// Student's t with 9 degrees of freedom: 95 % lie within 2.262 standard errors.
TEST_CASE("intervals of 95 % cover the truth in 90 to 99 % of cases" * doctest::test_suite("statistics"))
{
    constexpr int replicates = 10;
    constexpr double student = 2.262;
    const Scene cube = uneven_cube();
    const std::vector<Rgb> exact = solve(cube, options_of(Method::reuse, "sobol-owen", 1u << 16), silent).radiosity;
    for (const Method method : {Method::local, Method::extended}) {
        const double share = coverage(cube, options_of(method, "random", 1u << 17), replicates, student, exact);
        CAPTURE(method->name);
        CHECK(share > 0.90);
        CHECK(share < 0.99);
    }
    const Scene cubes(read_obj("scenes/5cubes.obj"), 0.5);
    const std::vector<Rgb> truth = solve(cubes, options_of(Method::reuse, "sobol-owen", 1u << 22), silent).radiosity;
    for (const char* sequence : {"random", "sobol"}) {
        const double share = coverage(cubes, options_of(Method::reuse, sequence, 1u << 17), replicates, student, truth);
        CAPTURE(sequence);
        CHECK(share > 0.90);
        CHECK(share < 0.99);
    }
}

// A yard between two houses, one of them lit within, below a sky and a lamp that stands in the yard.
TEST_CASE("in open scenes, too, intervals of 95 % cover the truth" * doctest::test_suite("statistics"))
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.6, 0.0);
    builder.rectangle({0, 0, 0}, {0, 0, 4}, {5, 0, 0}, grey);
    builder.box({0.5, 0, 0.5}, {1.5, 2, 3.5}, grey).box({3, 0, 1}, {4.5, 1.5, 3}, grey);
    builder.rectangle({2, 0, 2}, {0, 0.8, 0}, {0, 0, 0.5}, builder.grey(0.2, 5.0));
    SceneFile file = builder.file();
    add_sky(file, {1.0, 1.0, 1.0});
    const Scene scene(file, 0.5);
    constexpr int replicates = 10;
    constexpr double student = 2.262;
    for (const bool table : {true, false}) {
        SolveOptions options = options_of(Method::reuse, "sobol-owen", 1u << 23);
        const std::vector<Rgb> truth = solve(scene, options, silent).radiosity;
        options.all_pairs = table;
        options.lines = std::uint64_t{640} * scene.patch_count();
        const double share = coverage(scene, options, replicates, student, truth);
        CAPTURE(table);
        CAPTURE(scene.patch_count());
        CHECK(share > 0.90);
        CHECK(share < 0.99);
    }
}

TEST_CASE(
    "replicates of many patches with few lines each do without a table of pairs, which all lines together pay for")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    builder.room({0, 0, 0}, {1, 1, 1}, grey);
    builder.rectangle({0.45, 0.95, 0.45}, {0.1, 0, 0}, {0, 0, 0.1}, builder.grey(0.5, 100.0));
    const Scene scene = builder.scene(1.0 / 29.0);
    REQUIRE(scene.patch_count() == 5055);
    SolveOptions options = options_of(Method::reuse, "sobol-owen", std::uint64_t{512} * scene.patch_count());
    CHECK(solve(scene, options, silent).global_lines > 0);
    const Solution solution = solve_incrementally(scene, options, 8, silent, nullptr, {});
    CHECK(solution.global_lines == 0);
    CHECK(*solution.relative_standard_error < 0.05);
}

TEST_CASE("replicates share the lines, and each randomised kind gives independent ones")
{
    const Scene scene = uneven_cube();
    for (const char* sequence : {"random", "sobol", "halton:2,7,3,5", "kronecker"}) {
        const SolveOptions options = options_of(Method::first_shot, sequence, 10001);
        const Solution s = solve_replicates(scene, prepare(scene, options), options, 4, silent);
        CAPTURE(sequence);
        CHECK(s.local_lines + s.global_lines == 10001);
        CHECK(s.all_lines == 10001);
        CHECK(s.replicates == 4);
        CHECK(*s.relative_standard_error > 0.0);
        CHECK(s.balance.relative_error() < 1e-9);
        for (const Rgb e : s.standard_error)
            CHECK(e.g > 0.0);
    }
    const SolveOptions fixed = options_of(Method::first_shot, "hammersley:100000", 10000);
    CHECK_THROWS_AS(solve_replicates(scene, prepare(scene, fixed), fixed, 4, silent), std::invalid_argument);
}

TEST_CASE("rounds have the lines that the caller wants, until there are enough")
{
    const Scene scene = uneven_cube();
    std::vector<Round> rounds;
    const auto three = [&](const Round& round) {
        rounds.push_back(round);
        return rounds.size() < 3 ? 2 * round.lines : 0;
    };
    const Solution s = solve_in_rounds(scene, options_of(Method::extended, "sobol", 0), 3, 3000, three, silent);
    CHECK(rounds.size() == 3);
    CHECK(rounds[2].lines == 12000);
    CHECK(s.local_lines + s.global_lines == 12000);
    CHECK(s.all_lines == 21000);
    CHECK(rounds[2].relative_standard_error == *s.relative_standard_error);
}

// The error of the mean m of n runs x is sqrt(sum (x - m)^2 / (n (n - 1))); the runs follow from the means of the first
// 1, 2 ... of them, which is what work that is left has found.
TEST_CASE("the standard error is that of the mean of independent runs")
{
    const Scene scene = uneven_cube();
    SolveOptions options = options_of(Method::first_shot, "random", 4000);
    options.threads = 1;
    for (const int replicates : {2, 4}) {
        CAPTURE(replicates);
        std::vector<std::vector<Rgb>> means(static_cast<std::size_t>(replicates));
        for (int pause = 0;; ++pause) {
            TestCheckpoint left(pause);
            const Solution then = solve_replicates(scene, prepare(scene, options), options, replicates, silent, &left);
            means[static_cast<std::size_t>(then.replicates) - 1] = then.radiosity;
            CHECK(then.balance.emitted.g == doctest::Approx(3.0).epsilon(0.1)); // however many there are
            if (then.replicates < replicates)
                continue;
            for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
                double squares = 0.0;
                double sum_before = 0.0;
                for (std::size_t k = 0; k < means.size(); ++k) {
                    const double sum = static_cast<double>(k + 1) * means[k][i].g;
                    const double deviation = sum - sum_before - then.radiosity[i].g;
                    squares += deviation * deviation;
                    sum_before = sum;
                }
                CHECK(then.standard_error[i].g ==
                      doctest::Approx(std::sqrt(squares / (replicates * (replicates - 1.0)))).epsilon(1e-6));
            }
            break;
        }
    }
}

// The sequence and the order of the lines are the same for every seed.
TEST_CASE("a shard of independent lines is a run of its own that leaves out the items of those before")
{
    const Scene scene = irregular_scene();
    SolveOptions options = options_of(Method::global, "sobol", 5003);
    options.skip = 70;
    const GlobalLines lines(scene.bounds(), chords_of(options));
    for (const Shard shard : {Shard{0, 3}, Shard{1, 3}, Shard{2, 3}}) {
        CAPTURE(shard.number);
        SolveOptions alone = options;
        alone.lines = shard.end(options.lines) - shard.begin(options.lines);
        alone.skip += shard.number == 0 ? 0 : lines.lines_to_cast(shard.begin(options.lines));
        const Solution part = solve_incrementally(scene, options, 1, silent, nullptr, shard);
        CHECK(part.all_lines == alone.lines);
        CHECK(part.radiosity == solve(scene, alone, silent).radiosity);
    }
}

TEST_CASE("denoised replicates are their mean and the squares of its errors, denoised")
{
    const Scene scene = irregular_scene();
    SolveOptions options = options_of(Method::reuse, "sobol-owen", std::uint64_t{64} * scene.patch_count());
    options.all_pairs = false;
    options.denoise = false;
    const Preparation preparation = prepare(scene, options);
    const Solution plain = solve_replicates(scene, preparation, options, 3, silent);
    options.denoise = true;
    const Solution smooth = solve_replicates(scene, preparation, options, 3, silent);
    std::vector<Rgb> radiosity = plain.radiosity;
    std::vector<Rgb> variance;
    for (const Rgb& error : plain.standard_error)
        variance.push_back(error * error);
    denoise(scene, 1, radiosity, variance);
    CHECK(smooth.radiosity != plain.radiosity);
    CHECK(smooth.radiosity == radiosity);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        CHECK(smooth.standard_error[i].g == doctest::Approx(std::sqrt(variance[i].g)).epsilon(1e-12));
}

// The squares of the errors, by the areas of the patches, over the power that leaves them: without the sky's.
TEST_CASE("the sky has no part in the error of the whole")
{
    SceneBuilder builder;
    SceneFile file = builder.rectangle({0, 0, 0}, {0, 0, 1}, {2, 0, 0}, builder.grey(0.5, 0.0)).file();
    file.sun = sun_at(90, 45, {0, 1, 0}, {1, 1, 1});
    add_sky(file, {1, 1, 1});
    const Scene scene(file, 0.5, true);
    const SolveOptions options = options_of(Method::first_shot, "random", 4000);
    const Solution solution = solve_replicates(scene, prepare(scene, options), options, 2, silent);
    double squares = 0.0;
    double power = 0.0;
    double area = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (!scene.is_sky(scene.surface_of(i))) {
            const Rgb error = solution.standard_error[i];
            squares += scene.area(i) * mean(error * error);
            power += scene.area(i) * mean(solution.radiosity[i]);
            area += scene.area(i);
        }
    REQUIRE(solution.relative_standard_error);
    CHECK(*solution.relative_standard_error == doctest::Approx(std::sqrt(squares * area) / power));
}

} // namespace replicates_test
