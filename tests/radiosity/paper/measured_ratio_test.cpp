#include "radiosity/paper/measured_ratio.h"

#include "radiosity/paper/line_budget.h"
#include "radiosity/run/solve.h"
#include "scene/scene_builder.h"

#include <cmath>
#include <cstddef>
#include <doctest/doctest.h>
#include <limits>
#include <string>
#include <vector>

namespace measured_ratio_test {

using namespace multipath;

namespace {

const ProgressCallback silent = [](double) {};

/// A room with a block and a lamp below the ceiling; if open, without ceiling and one of its walls.
Scene room(double reflectance, bool open, bool two_sided)
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(reflectance, 0.0);
    const std::array<Surface, 6> walls = walls_of_room({0, 0, 0}, {2, 1.5, 2});
    for (const Surface& side : walls)
        if (const Vec3 n = side.normal(); !open || (std::abs(n.x - 1.0) > 1e-9 && std::abs(n.y + 1.0) > 1e-9))
            builder.surface(side, wall);
    builder.box({0.3, 0.3, 0.3}, {0.9, 0.8, 0.9}, builder.grey(0.6 * reflectance, 0.0));
    builder.rectangle({0.9, 1.4, 0.9}, {0.3, 0, 0}, {0, 0, 0.3}, builder.grey(0.0, 10.0));
    return builder.scene(0.25, two_sided);
}

LineVariances variances_of(const Scene& scene, const SolveOptions& options)
{
    const auto sequence = make_line_sequence(options.sequence, 1, options.pairing);
    ExtendedShotOptions shot;
    shot.threshold = threshold_radiosity(scene);
    shot.most_steps = options.method->first_shot == FirstShot::plain ? 1 : options.most_steps;
    PilotShot pilot{PowerState(scene), {}};
    pilot.passes = shoot_pilot(scene, *sequence, 0, shot, 4096, 1, pilot.after);
    const GlobalLines lines(scene.bounds(), chords_of(options));
    return line_variances(scene, pilot, walk_density(scene, lines, *sequence, 0, options.bidirectional));
}

/// [W^2/m^2] Variance of the radiosity, summed over the area, by independent runs; and the same as (V1) and (V2) say.
struct Variance
{
    double measured = 0.0;
    double expected = 0.0;
};

Variance variance_of(const Scene& scene, SolveOptions options, const LineVariances& of_a_line)
{
    constexpr int runs = 40;
    std::vector<double> sum(scene.patch_count());
    std::vector<double> squares(scene.patch_count());
    Variance result;
    for (int run = 0; run < runs; ++run) {
        options.seed = static_cast<std::uint64_t>(run + 1);
        const Solution solution = solve(scene, options, silent);
        for (std::size_t i = 0; i < sum.size(); ++i) {
            const double b = mean(solution.radiosity[i]);
            sum[i] += b;
            squares[i] += b * b;
        }
        result.expected += (of_a_line.local / static_cast<double>(solution.local_lines) +
                            of_a_line.global / static_cast<double>(solution.global_lines)) /
                           runs;
    }
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        result.measured += scene.area(i) * (squares[i] - sum[i] * sum[i] / runs) / (runs - 1);
    return result;
}

} // namespace

// In a closed room the mean square of a packet is that of (V2) if packets mix well; in an open one those from near the
// openings are fewer. The measured variance has a standard error of about 2 %, the pilot adds 2 %.
TEST_CASE("the variance of a run is what a pilot expects, in closed and open rooms, dark and white, one way and both")
{
    struct Case
    {
        double reflectance;
        bool open;
        bool two_sided;
        bool bidirectional;
    };
    for (const Case& tried :
         {Case{0.2, false, false, true}, Case{0.5, false, false, true}, Case{0.5, false, false, false},
          Case{0.9, false, false, true}, Case{0.5, true, false, true}, Case{0.5, true, true, true}}) {
        const Scene scene = room(tried.reflectance, tried.open, tried.two_sided);
        for (const char* method : {"first-shot", "extended"}) {
            CAPTURE(method);
            CAPTURE(tried.reflectance);
            CAPTURE(tried.open);
            CAPTURE(tried.two_sided);
            CAPTURE(tried.bidirectional);
            SolveOptions options;
            options.method = method_named(method);
            options.sequence = "random";
            options.bidirectional = tried.bidirectional;
            options.lines = 1u << 16;
            const LineVariances variances = variances_of(scene, options);
            for (const double times : {0.25, 1.0, 2.0}) { // mostly local variance, half, mostly global
                options.ratio = times * best_ratio(variances).value();
                const Variance variance = variance_of(scene, options, variances);
                CHECK(variance.measured == doctest::Approx(variance.expected).epsilon(tried.open ? 0.16 : 0.1));
            }
        }
    }
}

TEST_CASE("the best ratio is that of the standard errors of a line")
{
    CHECK(best_ratio({4.0, 1.0}).value() == doctest::Approx(2.0));
    CHECK(best_ratio({1.0, 9.0}).value() == doctest::Approx(1.0 / 3.0));
    CHECK_FALSE(best_ratio({0.0, 1.0}));
    CHECK(best_ratio({1.0, 0.0}).value() == 1e12);
    CHECK(best_ratio({1e300, 1e-300}).value() == 1e12);
}

TEST_CASE("where nothing reflects there is no best ratio, and a run by the measured ratio is as dark as any")
{
    SceneBuilder builder;
    builder.room({0, 0, 0}, {1, 1, 1}, builder.grey(0.0, 0.0));
    builder.rectangle({0.4, 0.9, 0.4}, {0.2, 0, 0}, {0, 0, 0.2}, builder.grey(0.0, 1.0));
    const Scene scene = builder.scene(0.5);
    SolveOptions options;
    options.lines = 1000;
    options.measured_ratio = true;
    for (const char* method : {"first-shot", "extended"}) {
        options.method = method_named(method);
        CHECK_FALSE(best_ratio(variances_of(scene, options)));
        const Solution solution = solve(scene, options, silent);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            CHECK(solution.radiosity[i].r == scene.emittance(i).r);
    }
}

} // namespace measured_ratio_test
