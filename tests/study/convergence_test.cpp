#include "study/convergence.h"

#include "irregular_scene.h"
#include "radiosity/run/statistics.h"
#include "scene/scratch_folder.h"
#include "test_scenes.h"

#include <cmath>
#include <csignal>
#include <doctest/doctest.h>
#include <fstream>
#include <sstream>
#include <stdexcept>
#ifndef _WIN32
#include <sys/resource.h>
#endif

namespace convergence_test {

using namespace multipath;

namespace {

const ProgressCallback silent = [](double) {};

Scene small_room()
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 0.0);
    const std::uint32_t lamp = builder.grey(0.2, 1.0);
    return builder.room({0, 0, 0}, {1, 1, 1}, {wall, lamp, wall, wall, wall, wall}).scene(0.5);
}

CurvePlan curve(const char* method, Method option, const char* sequence)
{
    CurvePlan plan{{method, sequence, "4d", "sphere", "shuffled"}, {}};
    plan.options.method = option;
    plan.options.sequence = sequence;
    return plan;
}

Reference reference_of(const Scene& scene)
{
    SolveOptions options;
    options.method = Method::reuse; // exact form factors: nothing stands in the way
    options.lines = 1u << 16;
    return {solve(scene, options, silent).radiosity, {}};
}

double error_of(const Scene& scene, const SolveOptions& options, const Reference& reference)
{
    return measure_error(scene.areas(), solve(scene, options, silent).radiosity, reference.radiosity)
        .relative_mean_square;
}

} // namespace

// The slope's own standard error is the scale; 4 of them, and 0.05 for the leftover of the shortest walks.
TEST_CASE("random lines have the slope -1" * doctest::test_suite("statistics"))
{
    const Scene scene = small_room();
    StudyPlan plan;
    plan.curves = {curve("local", Method::local, "random"), curve("global", Method::global, "random")};
    plan.line_counts = {1u << 12, 1u << 13, 1u << 14, 1u << 15, 1u << 16};
    plan.executions = 16;
    Journal journal;
    const Study study = run_study(scene, reference_of(scene), plan, journal, 2, silent);
    REQUIRE(study.curves.size() == 2);
    for (const Curve& curve : study.curves) {
        REQUIRE(curve.law);
        CHECK(curve.law->exponent_error < 0.06);
        CHECK(std::abs(curve.law->exponent + 1.0) < 4.0 * curve.law->exponent_error + 0.05);
    }
}

TEST_CASE("executions of a sequence without a seed are its successive stretches, the first its beginning")
{
    const Scene scene = small_room();
    const Reference reference = reference_of(scene);
    StudyPlan plan;
    plan.curves = {curve("global", Method::global, "sobol")};
    plan.line_counts = {1000};
    plan.executions = 2;
    Journal journal;
    (void)run_study(scene, reference, plan, journal, 1, silent);
    SolveOptions options = plan.curves[0].options;
    options.lines = 1000;
    const auto executed = [&](int number) {
        return journal.find(execution_name("global sobol 4d sphere shuffled", 1000, number))->relative;
    };
    CHECK(executed(0) == error_of(scene, options, reference));
    options.skip = 2048; // the cube's sphere has pi / 2 times its surface: 1571 chords for 1000 lines
    CHECK(executed(1) == error_of(scene, options, reference));
}

// The mean square over the areas of patches other than the sky's, relative to their mean radiosity.
TEST_CASE("the sky has no part in the error of a point")
{
    const Scene scene = irregular_scene();
    const Reference reference = {irregular_values(scene.patch_count(), 7), {}};
    StudyPlan plan;
    plan.curves = {curve("global", Method::global, "sobol")};
    plan.line_counts = {700};
    plan.executions = 1;
    Journal journal;
    const Study study = run_study(scene, reference, plan, journal, 1, silent);
    SolveOptions options = plan.curves[0].options;
    options.lines = 700;
    const std::vector<Rgb> found = solve(scene, options, silent).radiosity;
    double squares = 0.0;
    double power = 0.0;
    double area = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (!scene.is_sky_patch(i)) {
            const Rgb error = found[i] - reference.radiosity[i];
            squares += scene.area(i) * mean(error * error);
            power += scene.area(i) * mean(reference.radiosity[i]);
            area += scene.area(i);
        }
    const CurvePoint point = study.curves.at(0).points.at(0);
    CHECK(point.mean_square == doctest::Approx(squares / area).epsilon(1e-12));
    CHECK(point.relative == doctest::Approx(squares * area / (power * power)).epsilon(1e-12));
}

TEST_CASE("executions of a random sequence are all different, also between numbers of lines")
{
    const Scene scene = small_room();
    StudyPlan plan;
    plan.curves = {curve("global", Method::global, "random")};
    plan.line_counts = {1000, 1001};
    plan.executions = 3;
    Journal journal;
    (void)run_study(scene, reference_of(scene), plan, journal, 1, silent);
    const auto executed = [&](std::uint64_t lines, int number) {
        return journal.find(execution_name("global random 4d sphere shuffled", lines, number))->relative;
    };
    CHECK(executed(1000, 0) != executed(1000, 1));
    CHECK(executed(1000, 1) != executed(1000, 2));
    CHECK(std::abs(executed(1000, 0) / executed(1001, 0) - 1.0) > 0.01); // one line more alone changes less
}

TEST_CASE("a study does not depend on the number of threads, times apart")
{
    const Scene scene = small_room();
    const Reference reference = reference_of(scene);
    StudyPlan plan;
    plan.curves = {curve("global", Method::global, "random"), curve("reuse", Method::reuse, "sobol-owen")};
    plan.line_counts = {500, 1000, 2000};
    plan.executions = 2;
    Journal one;
    Journal three;
    const Study alone = run_study(scene, reference, plan, one, 1, silent);
    const Study together = run_study(scene, reference, plan, three, 3, silent);
    for (std::size_t c = 0; c < 2; ++c)
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(alone.curves[c].points[k].relative == together.curves[c].points[k].relative);
            CHECK(alone.curves[c].points[k].relative_error == together.curves[c].points[k].relative_error);
        }
}

TEST_CASE("runs that the journal knows are not repeated")
{
    const Scene scene = small_room();
    StudyPlan plan;
    plan.curves = {curve("global", Method::global, "sobol")};
    plan.line_counts = {1000, 2000};
    plan.executions = 2;
    Journal journal;
    for (const std::uint64_t lines : plan.line_counts)
        for (const int number : {0, 1})
            journal.add(execution_name("global sobol 4d sphere shuffled", lines, number),
                        {lines, 600, 400, 8.0, 2.0 + number, 0.0, 5.0});
    int reports = 0;
    const Study study = run_study(scene, reference_of(scene), plan, journal, 2, [&](double) { ++reports; });
    CHECK(reports == 0);
    for (const CurvePoint& point : study.curves[0].points) {
        CHECK(point.relative == 2.5);       // the mean of 2 and 3
        CHECK(point.relative_error == 0.5); // |3 - 2| / 2 for two values
        CHECK(point.mean_square == 8.0);
        CHECK(point.seconds == 5.0);
        CHECK(point.local_lines == 600.0);
    }
}

TEST_CASE("a point less than ten times above the error of the reference is left out of the fit")
{
    const Scene scene = small_room();
    Reference reference{std::vector<Rgb>(scene.patch_count()), 1e-3};
    StudyPlan plan;
    plan.curves = {curve("global", Method::global, "sobol")};
    plan.line_counts = {1000, 2000, 4000, 8000};
    Journal journal;
    const double errors[] = {8e-2, 4e-2, 2e-2, 0.999e-2};
    for (std::size_t k = 0; k < 4; ++k)
        journal.add(execution_name("global sobol 4d sphere shuffled", plan.line_counts[k], 0),
                    {plan.line_counts[k], 0, 1, 1.0, errors[k], 0.0, 1.0});
    const Curve found = run_study(scene, reference, plan, journal, 1, silent).curves[0];
    for (std::size_t k = 0; k < 4; ++k)
        CHECK(found.points[k].above_reference == (k < 3));
    REQUIRE(found.law);
    CHECK(found.law->points == 3);
    CHECK(found.law->exponent == doctest::Approx(-1.0));
}

} // namespace convergence_test

namespace journal_test {

using namespace multipath;

namespace {

const std::string curve = "global halton:2,7,3,5 4d sphere shuffled";
const std::string key = execution_name(curve, 1u << 20, 3);
const CurvePoint execution{1u << 20, 123, 456, 0.1, 1.0 / 3.0, 0.0, 2.0 / 7.0};

std::string text_of(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

void write(const std::string& path, const std::string& text)
{
    std::ofstream(path, std::ios::binary) << text;
}

} // namespace

TEST_CASE("a journal gives back what was added, to the bit")
{
    const ScratchFolder folder;
    const std::string path = folder.path("runs.txt");
    {
        Journal journal(path, "identity");
        CHECK(!journal.find(key));
        journal.add(key, execution);
    }
    const Journal journal(path, "identity");
    const auto found = journal.find(key);
    REQUIRE(found);
    CHECK(found->local_lines == execution.local_lines);
    CHECK(found->global_lines == execution.global_lines);
    CHECK(found->mean_square == execution.mean_square);
    CHECK(found->relative == execution.relative);
    CHECK(found->seconds == execution.seconds);
    CHECK(!journal.find(execution_name(curve, 1u << 20, 4)));
    CHECK(!journal.find(execution_name(curve, (1u << 20) + 1, 3)));
    CHECK(!journal.find(execution_name("global sobol 4d sphere shuffled", 1u << 20, 3)));
}

TEST_CASE("wherever a journal is cut off, what is left of it is used, and it can be continued")
{
    const ScratchFolder folder;
    const std::string path = folder.path("runs.txt");
    {
        Journal journal(path, "identity");
        journal.add("a 1 0", execution);
        journal.add("a 2 0", execution);
    }
    const std::string whole = text_of(path);
    const std::size_t second = whole.find("a 2");
    for (std::size_t size = 0; size <= whole.size(); ++size) {
        write(path, whole.substr(0, size));
        Journal journal(path, "identity");
        CHECK(journal.find("a 1 0").has_value() == (size + 1 >= second));
        journal.add("a 3 0", execution);
        CHECK(Journal(path, "identity").find("a 3 0"));
    }
}

TEST_CASE("a damaged run is not believed, the others are")
{
    const ScratchFolder folder;
    const std::string path = folder.path("runs.txt");
    {
        Journal journal(path, "identity");
        journal.add("a 1 0", execution);
        journal.add("a 2 0", execution);
    }
    std::string text = text_of(path);
    text[text.find("a 1") + 8] ^= 1;
    write(path, text);
    const Journal journal(path, "identity");
    CHECK(!journal.find("a 1 0"));
    CHECK(journal.find("a 2 0"));
}

TEST_CASE("runs of another identity are not those of this study")
{
    const ScratchFolder folder;
    const std::string path = folder.path("runs.txt");
    {
        Journal journal(path, "one scene");
        journal.add(key, execution);
    }
    CHECK(!Journal(path, "another scene").find(key));
    CHECK(text_of(path) == "another scene\n");
}

TEST_CASE("a journal that cannot be written says so")
{
    CHECK_THROWS_WITH(Journal("/nonexistent/runs.txt", "identity"),
                      "cannot write /nonexistent/runs.txt: No such file or directory");
}

#ifndef _WIN32
// A limit on the size of files stands for a full disk, which takes a part of the bytes too and refuses the rest.
TEST_CASE("a disk that is full is an error with its reason")
{
    const ScratchFolder folder;
    rlimit before = {};
    REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small = {3, before.rlim_max};
    REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
    const std::string path = folder.path("runs.txt");
    CHECK_THROWS_WITH_AS(Journal(path, "study 1"), ("cannot write " + path + ": File too large").c_str(),
                         std::runtime_error);
    setrlimit(RLIMIT_FSIZE, &before);
}
#endif

} // namespace journal_test
