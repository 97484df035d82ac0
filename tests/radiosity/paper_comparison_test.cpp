// The comparison of section 4 of the paper in numbers: random lines, mean of 6 runs, 2^18 lines each, on scenes with
// the parameters that it states. The reference is the extended first shot with 32 times as many quasi-random lines,
// whose error is below 2 % of those compared.

#include "radiosity/run/solve.h"
#include "radiosity/run/statistics.h"
#include "scene/obj/obj_reader.h"

#include <cmath>
#include <doctest/doctest.h>

namespace paper_comparison_test {

using namespace multipath;

namespace {

struct MeanErrors
{
    double local = 0.0;
    double first_shot = 0.0;
    double extended = 0.0;
};

MeanErrors mean_errors(const char* path)
{
    const ProgressCallback silent = [](double) {};
    const Scene scene(read_obj(path), 0.25);
    SolveOptions options;
    options.threads = 2;
    options.sequence = "sobol-owen";
    options.method = Method::extended;
    options.lines = 1u << 23;
    const std::vector<Rgb> reference = solve(scene, options, silent).radiosity;

    options.sequence = "random";
    options.lines = 1u << 18;
    const auto mean_error = [&](Method method) {
        options.method = method;
        double sum = 0.0;
        for (options.seed = 1; options.seed <= 6; ++options.seed)
            sum += measure_error(scene.areas(), solve(scene, options, silent).radiosity, reference).mean_square;
        return sum / 6.0;
    };
    return {mean_error(Method::local), mean_error(Method::first_shot), mean_error(Method::extended)};
}

} // namespace

TEST_CASE(
    "lit towards the ceiling, the extended first shot is far better than the first shot and near local Monte Carlo" *
    doctest::test_suite("statistics"))
{
    const MeanErrors error = mean_errors("scenes/4chairs-up.obj"); // Figures 7 and 8
    CHECK(error.first_shot >= 5.0 * error.extended);
    CHECK(error.extended <= 2.0 * error.local);
    CHECK(error.local <= 2.0 * error.extended);
}

// A mean of 6 runs is known to 2 %: the first shot is not told apart from local Monte Carlo (0.98 times its error in
// longer runs), the extended one is 20 % better.
TEST_CASE("lit towards the floor, neither is worse than local Monte Carlo, and both are near each other" *
          doctest::test_suite("statistics"))
{
    const MeanErrors error = mean_errors("scenes/4chairs.obj"); // Figure 9
    CHECK(error.first_shot < 1.06 * error.local);
    CHECK(error.extended < error.local);
    CHECK(std::abs(error.first_shot - error.extended) < 0.3 * error.first_shot);
}

} // namespace paper_comparison_test
