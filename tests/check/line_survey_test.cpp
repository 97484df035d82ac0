#include "check/scene_report.h"

#include "radiosity/paper/line_budget.h"
#include "sampling/random.h"
#include "sampling/warp.h"
#include "test_scenes.h"

#include <cmath>
#include <doctest/doctest.h>

namespace line_survey_test {

using namespace multipath;

// Counts of binomial variables: 4 standard deviations are below 4 sqrt(count).
TEST_CASE("the surveyed lines agree with integral geometry")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 1.0);
    const Scene scene = builder.room({0, 0, 0}, {3, 2, 1}, wall).box({1, 0.5, 0.2}, {2, 1, 0.7}, wall).scene(1.0);
    const SceneReport report = report_on(scene, 100000, 2);
    CHECK(report.survey.lines == 100000);
    CHECK(report.figures.intersections == doctest::Approx(2 * (22 + 2 * (0.5 + 0.25 + 0.5)) / 22));
    CHECK(report.intersections_measured == doctest::Approx(report.figures.intersections).epsilon(0.01));
}

TEST_CASE("a line crosses surfaces as often as (G2) says, in boxes and in what leaves much of its box empty")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    std::uint64_t number = 0;
    const auto random = [&number] { return bits_to_unit(random_bits(1, number++)); };
    for (int k = 0; k < 400; ++k) {
        const Vec3 p = square_to_uniform_sphere(random(), random());
        builder.triangle(p, normalized(p + Vec3{0.1, 0, 0}), normalized(p + Vec3{0, 0.06, 0.08}), grey);
    }
    const Scene scene = builder.scene(1.0);
    for (const bool two_sided : {false, true}) {
        const SceneReport report = report_on(Scene(builder.file(), 1.0, two_sided), 60000, 2);
        CHECK(report.figures.intersections == doctest::Approx(2.0 * scene.total_area() / scene.bounds().area()));
        CHECK(report.intersections_measured == doctest::Approx(report.figures.intersections).epsilon(0.06));
    }
}

TEST_CASE("every departure of a closed scene arrives, half of an open pair's do not")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    const Scene room = builder.room({0, 0, 0}, {1, 1, 1}, grey).scene(1.0);
    const LineSurvey closed = survey_lines(room, 10000, 1);
    for (std::size_t s = 0; s < 6; ++s) {
        CHECK(closed.departures[s] > 1000);
        CHECK(closed.arrivals[s] == closed.departures[s]);
        CHECK(closed.met_behind[s] == 0);
    }
    SceneBuilder pair;
    const std::uint32_t one = pair.grey(0.5, 1.0);
    pair.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, one)
        .rectangle({0, 1, 0}, {0, 0, 1}, {1, 0, 0}, one); // both look up
    const Scene two = pair.scene(1.0);
    const LineSurvey open = survey_lines(two, 10000, 3);
    CHECK(open.arrivals[0] + open.arrivals[1] == 0);
    CHECK(open.met_behind[1] <= open.departures[0]);
    CHECK(open.met_behind[0] == 0);
    CHECK(open.met_behind[1] > 100);
}

} // namespace line_survey_test
