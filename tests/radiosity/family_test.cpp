// What the papers of the methods claim of them, on a closed box with two floating blocks (744 patches). The reference
// is line reuse with many lines, whose error is below a hundredth of those compared.

#include "radiosity/run/solve.h"
#include "radiosity/run/statistics.h"
#include "scene/obj/obj_reader.h"
#include "scene/scene_builder.h"
#include "statistics.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace family_test {

using namespace multipath;

namespace {

const ProgressCallback silent = [](double) {};

class Box
{
public:
    Box() : scene_(read_obj("tests/fixtures/reference/box744.obj"), 0.1)
    {
        SolveOptions options;
        options.method = Method::reuse;
        options.lines = 1u << 22;
        options.threads = 2;
        reference_ = solve(scene_, options, silent).radiosity;
    }

    /// Relative mean square error, mean of four runs.
    double error(SolveOptions options, const std::string& sequence, std::uint64_t lines) const
    {
        options.sequence = sequence;
        options.lines = lines;
        options.threads = 2;
        double sum = 0.0;
        for (options.seed = 1; options.seed <= 4; ++options.seed)
            sum += measure_error(scene_.areas(), solve(scene_, options, silent).radiosity, reference_)
                       .relative_mean_square;
        return sum / 4.0;
    }

    const Scene& scene() const { return scene_; }

private:
    Scene scene_;
    std::vector<Rgb> reference_;
};

SolveOptions settings_of(Method method)
{
    SolveOptions options;
    options.method = method;
    return options;
}

} // namespace

// Neumann, Neumann, Bekaert: Radiosity with well distributed ray sets (1997): the error falls faster than that of
// random rays. Bekaert (1999): transfers in both directions reduce it to a half or less.
TEST_CASE("stochastic Jacobi iterations gain by evenly spread rays and by transfers in both directions" *
          doctest::test_suite("statistics"))
{
    const Box box;
    SolveOptions both_ways = settings_of(Method::jacobi);
    SolveOptions one_way = both_ways;
    one_way.bidirectional = false;
    const double even = box.error(both_ways, "sobol-owen", 1u << 20);
    CHECK(box.error(both_ways, "random", 1u << 20) > 2.5 * even);
    CHECK(box.error(one_way, "sobol-owen", 1u << 20) > 1.5 * even);
    CHECK(box.error(both_ways, "sobol-owen", 1u << 17) > 1.15 * 8.0 * even); // slope -1.07 and steeper
}

// Szirmay-Kalos, Foris, Neumann, Csebfalvi (1997): quasi-random directions beat random ones.
TEST_CASE("transillumination gains by evenly spread directions" * doctest::test_suite("statistics"))
{
    const Box box;
    const SolveOptions options = settings_of(Method::transillumination);
    CHECK(box.error(options, "random", 1u << 19) > 1.5 * box.error(options, "sobol-owen", 1u << 19));
}

// Bekaert (1999): counting a walk wherever it passes is better than where it ends; and of few small lamps gathering
// walks know less than shooting ones.
TEST_CASE("gathering walks gain by the collision estimator, and know less of a small lamp than shooting ones" *
          doctest::test_suite("statistics"))
{
    const Box box;
    SolveOptions collision = settings_of(Method::gathering);
    SolveOptions absorption = collision;
    absorption.estimator = Estimator::absorption;
    const double error = box.error(collision, "random", 1u << 18);
    CHECK(box.error(absorption, "random", 1u << 18) > 1.5 * error);
    CHECK(error > 10.0 * box.error(settings_of(Method::local), "random", 1u << 18));
}

// Red light that arrives at a green lamp goes on with probability 0.3, the mean reflectance, as black light. A path is
// counted where it is absorbed, not where it has become black, which would count 1 / 0.7 times what arrives.
TEST_CASE("the absorption estimator is unbiased where a path goes on without power")
{
    SceneBuilder builder;
    const std::uint32_t red = builder.material({0.9, 0.0, 0.0}, {});
    const std::uint32_t green_lamp = builder.material({0.0, 0.9, 0.0}, {1.0, 1.0, 1.0});
    const Scene scene = builder.room({0, 0, 0}, {1, 1, 1}, {red, green_lamp, red, red, red, red}).scene(0.5);
    SolveOptions options = settings_of(Method::gathering);
    options.lines = 1u << 18;
    double sums[2] = {};
    for (const Estimator estimator : {Estimator::collision, Estimator::absorption}) {
        options.estimator = estimator;
        const Solution solution = solve(scene, options, silent);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            sums[estimator == Estimator::absorption] += scene.area(i) * solution.radiosity[i].r;
    }
    CHECK(sums[1] == doctest::Approx(sums[0]).epsilon(0.02)); // the noise is below 1 %
}

TEST_CASE("the methods take about as many lines as they are given, also few, and directions of many lines at a time")
{
    const Box box;
    for (const Method method : {Method::jacobi, Method::transillumination, Method::gathering})
        for (const std::uint64_t lines : {1u, 2u, 17u, 1000u, 100000u}) {
            CAPTURE(method->name);
            SolveOptions options = settings_of(method);
            options.lines = lines;
            for (const std::uint64_t bundle : {1u, 64u}) {
                options.bundle = bundle;
                const Solution solution = solve(box.scene(), options, silent);
                const double used = static_cast<double>(solution.all_lines);
                CHECK(used <= 1.05 * static_cast<double>(lines) + 40.0);
                CHECK(used >= 0.95 * static_cast<double>(lines) - 64.0);
                CHECK(solution.balance.relative_error() < 1e-9);
            }
        }
}

TEST_CASE("a flat scene, whose box has no volume, is solved")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, builder.grey(0.5, 2.0)); // looks up
    builder.rectangle({2, 0, 0}, {0, 0, 1}, {1, 0, 0}, builder.grey(0.5, 0.0));
    const Scene flat = builder.scene(0.25);
    for (const Method method : {Method::jacobi, Method::transillumination, Method::gathering}) {
        CAPTURE(method->name);
        SolveOptions options = settings_of(method);
        options.lines = 20000;
        const Solution solution = solve(flat, options, silent);
        CHECK(solution.radiosity.front().g == 2.0);
        CHECK(solution.radiosity.back().g == 0.0);
        CHECK(solution.balance.escaped.g == doctest::Approx(2.0).epsilon(0.05)); // of bundles: an estimate
    }
}

namespace {

/// Two closed rooms side by side, each with a lamp that covers its ceiling in part.
Scene two_rooms()
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.6, 0.0);
    const std::uint32_t lamp = builder.grey(0.0, 5.0);
    for (const double x : {0.0, 2.0}) {
        builder.room({x, 0, 0}, {x + 1, 1, 1}, wall);
        builder.rectangle({x + 0.4, 0.99, 0.4}, {0.2, 0, 0}, {0, 0, 0.2}, lamp); // looks down
    }
    return builder.scene(0.1);
}

struct PartError
{
    double error; ///< mean square over the patches of the first room, mean of the runs
    double bias;  ///< of their mean radiosity, in standard errors
};

PartError error_of_first_room(const Scene& scene, const std::vector<Rgb>& reference,
                              const std::shared_ptr<const Importance>& importance)
{
    std::vector<double> areas(scene.patch_count());
    double truth = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        areas[i] = scene.patch(i).shape.centre().x < 1.5 ? scene.area(i) : 0.0;
        truth += areas[i] * reference[i].g;
    }
    SolveOptions options = settings_of(Method::reuse);
    options.sequence = "sobol-owen";
    options.lines = 1u << 18;
    options.threads = 2;
    options.importance = importance;
    options.all_pairs = false; // by rays, as with importance
    double error = 0.0;
    std::vector<double> powers;
    constexpr int runs = 12;
    for (options.seed = 1; options.seed <= runs; ++options.seed) {
        const std::vector<Rgb> found = solve(scene, options, silent).radiosity;
        error += measure_error(areas, found, reference).mean_square / runs;
        double power = 0.0;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            power += areas[i] * found[i].g;
        powers.push_back(power);
    }
    const Estimate power = estimate(powers);
    return {error, (power.mean - truth) / power.standard_error};
}

} // namespace

// Without importance half of the rays serve the other room.
TEST_CASE("rays for the sake of one room know it better, and say the same" * doctest::test_suite("statistics"))
{
    const Scene scene = two_rooms();
    SolveOptions options = settings_of(Method::reuse);
    options.lines = 1u << 21;
    options.threads = 2;
    const std::vector<Rgb> reference = solve(scene, options, silent).radiosity;
    Importance first_room{std::vector<double>(scene.patch_count())};
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        first_room.weight[i] = scene.patch(i).shape.centre().x < 1.5 ? 1.0 : 0.0;
    const PartError without = error_of_first_room(scene, reference, nullptr);
    const PartError with = error_of_first_room(scene, reference, std::make_shared<const Importance>(first_room));
    CHECK(with.error < 0.75 * without.error);
    CHECK(std::abs(with.bias) < 4.5);
    CHECK(std::abs(without.bias) < 4.5);
}

} // namespace family_test
