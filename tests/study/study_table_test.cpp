#include "study/study_table.h"

#include "export/csv_text.h"
#include "scene/scratch_folder.h"

#include <cmath>
#include <doctest/doctest.h>
#include <string>

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

TEST_CASE("a study's table has a row for every point and the error of the reference")
{
    const Study study = two_curves();
    const ScratchFolder folder;
    const CsvTable table = read_csv(folder.write("study.csv", study_csv(study, {"command: multipath study"})));
    CHECK(std::stod(*comment_value(table.comments, "reference_relative_mse")) == study.reference_relative_square);
    REQUIRE(table.rows.size() == 8);
    for (std::size_t c = 0; c < 2; ++c)
        for (std::size_t k = 0; k < 4; ++k) {
            const CsvRow& row = table.rows[4 * c + k];
            const auto text = [&](const char* column) { return row.fields[table.column(column)]; };
            const auto number = [&](const char* column) { return table.number(row, table.column(column)); };
            const Curve& curve = study.curves[c];
            const CurvePoint& point = curve.points[k];
            const CurveKind kind = {text("method"), text("sequence"), text("pairing"), text("chords"),
                                    text("line_order")};
            CHECK(kind == curve.kind);
            CHECK(number("slope") == curve.law->exponent);
            CHECK(number("slope_error") == curve.law->exponent_error);
            CHECK(number("replicates") == 3);
            CHECK(number("lines") == static_cast<double>(point.lines));
            CHECK(number("local_lines") == point.local_lines);
            CHECK(number("global_lines") == point.global_lines);
            CHECK(number("mse") == point.mean_square);
            CHECK(number("relative_mse") == point.relative);
            CHECK(number("standard_error") == point.relative_error);
            CHECK(number("seconds") == point.seconds);
            CHECK(number("in_fit") == (point.above_reference ? 1.0 : 0.0));
        }
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
    CHECK(slope_words({}) == "none");
    CHECK(slope_words(PowerLaw{1.0, -1.0, 0.01, 7}) == "−1.000 ± 0.026"); // Student's t for 5 degrees: 2.571
}

} // namespace study_table_test
