#include "selftest/selftest.h"

#include "scene/scene_builder.h"

#include <doctest/doctest.h>

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
    for (const Check& check : known_scene_checks({known_scene("parallel")}, few_runs(1), silent)) {
        CAPTURE(check.method);
        CAPTURE(check.sequence);
        CHECK((check.sequence == "all" || check.standard_error > 0.0));
    }
}

TEST_CASE("the checks do not depend on the number of threads")
{
    const std::vector<KnownScene> scenes = {known_scene("parallel"), known_scene("facing-squares")};
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
