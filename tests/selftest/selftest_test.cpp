#include "selftest/selftest.h"

#include "radiosity/run/statistics.h"
#include "scene/scene_builder.h"

#include <doctest/doctest.h>
#include <limits>

namespace selftest_test {

using namespace multipath;

namespace {

const ProgressCallback silent = [](double) {};

SelftestSettings few_runs(int threads)
{
    SelftestSettings settings;
    settings.replicates = 8;
    settings.lines = 1 << 13;
    settings.threads = threads;
    return settings;
}

KnownScene known_scene(const std::string& name)
{
    for (const KnownScene& scene : known_scenes())
        if (scene.name == name)
            return scene;
    return {};
}

std::size_t wrong_checks(const std::vector<Check>& checks)
{
    const SignificanceTest test(checks);
    std::size_t count = 0;
    for (const Check& check : checks)
        count += test.outcome(check) == CheckOutcome::wrong ? 1 : 0;
    return count;
}

} // namespace

// Six sequences; one answer for each, and the balance of each method.
TEST_CASE("a known scene passes, and without its screen it fails with every method and sequence")
{
    KnownScene screened = known_scene("screened");
    const std::vector<Check> checks = known_scene_checks({screened}, few_runs(2), silent);
    CHECK(checks.size() == all_methods().size() * (6 + 1));
    CHECK(wrong_checks(checks) == 0);
    SceneBuilder without_screen;
    for (std::size_t s = 0; s < 2; ++s)
        without_screen.surface(screened.file.surfaces[s], without_screen.grey(screened.file.materials[s].reflectance.g,
                                                                              screened.file.materials[s].emittance.g));
    screened.file = without_screen.file();
    CHECK(wrong_checks(known_scene_checks({screened}, few_runs(2), silent)) == all_methods().size() * 6);
}

TEST_CASE("runs differ from each other, also with a sequence that has no randomisation")
{
    for (const Check& check : known_scene_checks({known_scene("perpendicular")}, few_runs(1), silent)) {
        CAPTURE(check.method);
        CAPTURE(check.sequence);
        if (check.sequence == "all")
            continue;
        CHECK(check.standard_error > 0.0);
        CHECK(check.degrees == few_runs(1).replicates - 1);
        CHECK(check.allowance <= 0.01 * check.expected); // 1/200, and what a walk leaves unshot
    }
}

TEST_CASE("the checks do not depend on the number of threads")
{
    const std::vector<KnownScene> scenes = {known_scene("perpendicular"), known_scene("facing-squares")};
    CHECK(checks_csv(known_scene_checks(scenes, few_runs(1), silent), {}) ==
          checks_csv(known_scene_checks(scenes, few_runs(3), silent), {}));
}

// Local Monte Carlo is what the others are compared with: the other methods for two materials, and three checks
// of power for each. The lamp reflects nothing.
TEST_CASE("in a grey room every method gives each material the power that local Monte Carlo gives it")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 0.0);
    const std::uint32_t floor = builder.grey(0.3, 0.0);
    const std::uint32_t lamp = builder.grey(0.0, 2.0);
    const Scene scene = builder.room({0, 0, 0}, {1, 1, 1}, {floor, lamp, wall, wall, wall, wall}).scene(0.5);
    std::vector<double> progress;
    const std::vector<Check> checks = scene_checks(scene, few_runs(2), [&](double done) { progress.push_back(done); });
    CHECK(checks.size() == (all_methods().size() - 1) * 2 + all_methods().size() * 3);
    CHECK(SignificanceTest(checks).failures() == 0);
    CHECK(progress.size() == all_methods().size());
    CHECK(progress.back() == 1.0);
}

} // namespace selftest_test

namespace check_test {

using namespace multipath;

namespace {

/// A random check of expectation 10 that is off by so many standard errors of 0.1.
Check check_off(double sigmas, double allowance, double resolution)
{
    Check check = {"case", "method", "random", "quantity", 10.0, 10.0 + 0.1 * sigmas};
    check.standard_error = 0.1;
    check.degrees = 31;
    check.allowance = allowance;
    check.resolution = resolution;
    return check;
}

/// Runs of mean 10 and standard deviation 1, as a normal distribution has its quantiles.
Check check_of_runs(double expected)
{
    RunningMean mean;
    for (const double deviation : {-1.5, -1.0, -0.7, -0.4, -0.1, 0.1, 0.4, 0.7, 1.0, 1.5})
        mean.add(10.0 + deviation);
    Check check = {"case", "method", "random", "quantity", expected, mean.mean(), mean.standard_error(), 9};
    check.resolution = 5.0;
    return check;
}

} // namespace

TEST_CASE("a check may be off by its share of the risk")
{
    const std::vector<Check> checks(100, check_off(0.0, 0.0, 1.0));
    const SignificanceTest test(checks);
    const double most = test.most_sigmas(31);
    CHECK(100.0 * student_tail(most, 31) == doctest::Approx(1e-3).epsilon(1e-4));
    CHECK(test.outcome(check_off(0.99 * most, 0.0, 1.0)) == CheckOutcome::passed);
    CHECK(test.outcome(check_off(-1.01 * most, 0.0, 1.0)) == CheckOutcome::wrong);
    CHECK(test.outcome(check_off(-1.01 * most, 0.2, 1.0)) == CheckOutcome::passed);
    CHECK(SignificanceTest({checks[0]}).most_sigmas(31) < most);
}

// The standard error of the ten runs is 0.3, the quantile for 9 degrees of freedom and a tail of 0.001 is 4.78.
TEST_CASE("runs with a wrong mean fail, and so do those with a wrong variance")
{
    const auto outcome = [](const Check& check) { return SignificanceTest({check}).outcome(check); };
    CHECK(outcome(check_of_runs(10.0)) == CheckOutcome::passed);
    CHECK(outcome(check_of_runs(11.0)) == CheckOutcome::passed);
    CHECK(outcome(check_of_runs(12.0)) == CheckOutcome::wrong);

    Check repeated = check_of_runs(10.1); // runs that repeat each other have no scatter
    repeated.standard_error = 0.0;
    CHECK(outcome(repeated) == CheckOutcome::wrong);
    Check noisy = check_of_runs(10.0);
    noisy.standard_error *= 10.0;
    CHECK(outcome(noisy) == CheckOutcome::inconclusive);
}

TEST_CASE("a check whose limit is wider than its resolution is inconclusive, however right it is")
{
    const SignificanceTest test({check_off(0.0, 0.0, 1.0)});
    const double limit = test.limit(check_off(0.0, 0.3, 1.0));
    CHECK(test.outcome(check_off(0.0, 0.3, 1.01 * limit)) == CheckOutcome::passed);
    CHECK(test.outcome(check_off(0.0, 0.3, 0.99 * limit)) == CheckOutcome::inconclusive);
}

TEST_CASE("without randomness only the allowance counts, and what is not a number is wrong")
{
    Check check = {"case", "", "", "quantity", 1.0, 1.0 + 1e-10};
    check.allowance = 1e-9;
    check.resolution = 1e-9;
    CHECK(SignificanceTest({check}).outcome(check) == CheckOutcome::passed);
    check.measured = 1.0 + 1e-8;
    CHECK(SignificanceTest({check}).outcome(check) == CheckOutcome::wrong);
    check.measured = std::numeric_limits<double>::quiet_NaN();
    CHECK(SignificanceTest({check}).outcome(check) == CheckOutcome::wrong);
    CHECK(SignificanceTest({check, check_off(0.0, 0.0, 1.0)}).failures() == 1);
}

TEST_CASE("sigmas are counted beyond the allowance")
{
    CHECK(sigmas(check_off(3.0, 0.0, 1.0)) == doctest::Approx(3.0));
    CHECK(sigmas(check_off(-3.0, 0.1, 1.0)) == doctest::Approx(-2.0));
    CHECK(sigmas(check_off(0.5, 0.1, 1.0)) == 0.0);
}

TEST_CASE("the table ends with the counts, and can be of failures only")
{
    const std::vector<Check> checks = {check_off(0.0, 0.0, 1.0), check_off(50.0, 0.0, 1.0), check_off(0.0, 0.0, 0.1)};
    const std::string all = checks_text(checks, false);
    const std::string failed = checks_text(checks, true);
    CHECK(all.find("passed\n") < all.find("WRONG\n"));
    CHECK(all.find("WRONG\n") < all.find("INCONCLUSIVE\n"));
    CHECK(all.find("\na check fails beyond ") > all.find("INCONCLUSIVE\n"));
    CHECK(all.substr(all.rfind("0.001\n") + 6) == "1 passed, 2 failed\n");
    CHECK(failed.find("passed\n") == std::string::npos);
    CHECK(checks_text({checks[0]}, true) == "1 passed, 0 failed\n");
    CHECK(checks_csv({checks[1]}, {"version"}).substr(0, 15) == "# version\ncase,");
}

} // namespace check_test
