#include "commands/solve/solve_summary.h"

#include "commands/commands.h"
#include "scene/daylight.h"
#include "test_scenes.h"

#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <memory>
#include <optional>
#include <string>

namespace solve_summary_test {

using namespace multipath;

namespace {

/// A job with default options.
SolveJob job_of(const Accuracy& accuracy = {})
{
    return {CommandLine(solve_command().table, {"room.obj"}), {}, accuracy, {}, "sobol"};
}

/// The summary of a run in a cube of this reflectance, of which so much of 1 W is unshot and so much lost behind
/// surfaces.
std::string summary_of(double unshot, double behind, double rho = 0.5, const Accuracy& accuracy = {},
                       std::optional<double> noise = {})
{
    SceneBuilder builder;
    const Scene scene = builder.room({0, 0, 0}, {1, 1, 1}, builder.grey(rho, 1.0)).scene(1.0);
    const SolveJob job = job_of(accuracy);
    const auto grey = [](double power) { return Rgb{power, power, power}; };
    Solution solution;
    solution.global_lines = 1000;
    solution.radiosity.resize(scene.patch_count(), grey(1.0 / 6.0));
    solution.unshot.resize(scene.patch_count(), grey(unshot / 6.0));
    solution.balance.emitted = solution.balance.source = grey(1.0);
    solution.balance.unshot = grey(unshot);
    solution.balance.behind = grey(behind);
    solution.balance.absorbed = grey(1.0 - unshot - behind);
    solution.relative_standard_error = noise;
    solution.replicates = 4;
    return summary_text({job, scene, solution});
}

bool warns(const std::string& text, const char* of)
{
    const std::size_t warning = text.find("warning ");
    return warning != std::string::npos && text.find(of, warning) != std::string::npos;
}

} // namespace

TEST_CASE("power that is not distributed is warned of above 5 %, power lost behind surfaces above 0.1 %")
{
    CHECK(warns(summary_of(0.06, 0.0), "6 % of the power is not distributed yet"));
    CHECK(warns(summary_of(0.0, 0.002), "0.2 % of the power met surfaces from behind"));
    CHECK_FALSE(warns(summary_of(0.04, 0.0005), ""));
}

TEST_CASE("little unshot power is warned of where it would be reflected many times")
{
    CHECK(warns(summary_of(0.02, 0.0, 0.9), "brighter by 20 %"));
    CHECK_FALSE(warns(summary_of(0.02, 0.0, 0.75), ""));
}

// 3^2 + 4^2 = 5^2
TEST_CASE("the error is told with its parts, and what keeps it above the tolerance")
{
    Accuracy accuracy;
    CHECK(summary_of(0.0, 0.0, 0.5, accuracy, 0.04).find("error ") == std::string::npos); // the patches' is not known
    accuracy.patch_error = 0.03;
    CHECK(summary_of(0.0, 0.0, 0.5, accuracy, 0.04).find("error      5 % of the mean (patches 3 %, noise 4 %)") !=
          std::string::npos);
    accuracy.tolerance = 0.051;
    CHECK_FALSE(warns(summary_of(0.0, 0.0, 0.5, accuracy, 0.04), "above the tolerance"));
    accuracy.tolerance = 0.049;
    CHECK(warns(summary_of(0.0, 0.0, 0.5, accuracy, 0.04), "above the tolerance of 4.9 %: the limit of lines or time"));
    accuracy.tolerance = 0.02;
    CHECK(warns(summary_of(0.0, 0.0, 0.5, accuracy, 0.04), "above the tolerance of 2 %: there are too few patches"));
}

// Of patches of 1 and 3 m^2 and 1 W/m^2, with errors of 0.1 and 0.3: the root of (1 0.1^2 + 3 0.3^2) / 4.
TEST_CASE("the error of what is important counts patches by their area")
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, paint);
    builder.rectangle({0, 0, 1}, {0, 1, 0}, {3, 0, 0}, paint);
    const Scene scene = builder.scene(10.0);
    SolveJob job = job_of();
    job.options.importance = std::make_shared<const Importance>(Importance{{1.0, 1.0}});
    Solution solution;
    solution.radiosity = {{1, 1, 1}, {1, 1, 1}};
    solution.standard_error = {{0.1, 0.1, 0.1}, {0.3, 0.3, 0.3}};
    CHECK(SolveSummary{job, scene, solution}.error_of_important() == doctest::Approx(std::sqrt(0.07)));
}

TEST_CASE("the sky has no part in the mean reflectance that is told")
{
    SceneBuilder builder;
    SceneFile file = builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, builder.grey(0.25, 0.0)).file();
    add_sky(file, {1, 1, 1});
    const Scene scene(file, 1.0);
    const SolveJob job = job_of();
    Solution solution;
    solution.radiosity.resize(scene.patch_count());
    const std::string json = summary_json({job, scene, solution}).document();
    CHECK(std::strtod(json.substr(json.find("\"average_reflectance\": ") + 23).c_str(), nullptr) ==
          doctest::Approx(0.25));
}

} // namespace solve_summary_test
