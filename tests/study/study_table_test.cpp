#include "study/study_table.h"

#include "base/errors.h"
#include "scene/scratch_folder.h"

#include <cmath>
#include <doctest/doctest.h>

namespace study_table_test {

using namespace multipath;

namespace {

Study two_curves()
{
    Study study;
    study.executions = 3;
    study.reference_relative_square = 1.25e-8;
    for (const char* sequence : {"sobol", "halton:2,7,3,5"}) {
        Curve curve{{"first-shot", sequence, "4d", "sphere", "shuffled"}, {}, {}};
        for (int k = 0; k < 4; ++k) {
            CurvePoint point;
            point.lines = 1000u << k;
            point.local_lines = 600.0 * (1 << k);
            point.global_lines = 400.0 * (1 << k);
            point.relative = std::pow(static_cast<double>(point.lines), -1.1) * (1.0 + 0.1 * (k % 2));
            point.mean_square = 7.0 * point.relative;
            point.relative_error = point.relative / 30.0;
            point.seconds = 0.5 * (1 << k);
            point.above_reference = k < 3;
            curve.points.push_back(point);
        }
        curve.law = fit(curve.points);
        study.curves.push_back(curve);
    }
    return study;
}

} // namespace

TEST_CASE("a study's table read back is the study")
{
    const Study study = two_curves();
    const ScratchFolder folder;
    const Study read = read_study(folder.write("study.csv", study_csv(study, {"command: multipath study"})));
    CHECK(read.executions == 3);
    CHECK(read.reference_relative_square == study.reference_relative_square);
    REQUIRE(read.curves.size() == 2);
    for (std::size_t c = 0; c < 2; ++c) {
        CHECK(read.curves[c].kind == study.curves[c].kind);
        CHECK(read.curves[c].law->exponent == study.curves[c].law->exponent);
        CHECK(read.curves[c].law->exponent_error == study.curves[c].law->exponent_error);
        REQUIRE(read.curves[c].points.size() == 4);
        for (std::size_t k = 0; k < 4; ++k) {
            const CurvePoint& a = read.curves[c].points[k];
            const CurvePoint& b = study.curves[c].points[k];
            CHECK(a.lines == b.lines);
            CHECK(a.local_lines == b.local_lines);
            CHECK(a.mean_square == b.mean_square);
            CHECK(a.relative == b.relative);
            CHECK(a.relative_error == b.relative_error);
            CHECK(a.seconds == b.seconds);
            CHECK(a.above_reference == b.above_reference);
        }
    }
}

TEST_CASE("a table that is no study is refused by the name of what it lacks")
{
    const ScratchFolder folder;
    const std::string path = folder.write("other.csv", "method,lines\nreuse,5\n");
    CHECK_THROWS_AS((void)read_study(path), InputError);
}

TEST_CASE("the report marks the points left out of the fit and tells every slope")
{
    Study study = two_curves();
    study.curves[1].law.reset();
    const std::string text = study_text(study);
    CHECK(text.find("first-shot, sobol") != std::string::npos);
    CHECK(text.find("first-shot, halton:2,7,3,5") != std::string::npos);
    CHECK(text.find("slope -1.1") != std::string::npos);
    CHECK(text.find("slope: too few points") != std::string::npos);
    std::size_t marks = 0;
    for (std::size_t at = text.find("%*"); at != std::string::npos; at = text.find("%*", at + 1))
        ++marks;
    CHECK(marks == 2); // the last point of each curve
}

TEST_CASE("numbers in a report are short and have real signs")
{
    CHECK(fixed(-1.0964, 3) == "−1.096");
    CHECK(fixed(-0.0001, 2) == "0.00");
    CHECK(scientific(1.234e-7) == "1.2·10⁻⁷");
    CHECK(scientific(5e12) == "5.0·10¹²");
    CHECK(slope_words({}) == "none");
    CHECK(slope_words(PowerLaw{1.0, -1.0, 0.01, 7}) == "−1.000 ± 0.026"); // Student's t for 5 degrees: 2.571
}

} // namespace study_table_test
