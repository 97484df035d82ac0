#include "exam/exam_runs.h"
#include "exam/exam_table.h"
#include "radiosity/student_t.h"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>

namespace exam_row_test {

using namespace multipath;

namespace {

/// A random row of expectation 10 that is off by so many standard errors of 0.1.
ExamRow row_off(double sigmas, double allowance, double resolution)
{
    ExamRow row = {"case", "method", "random", "quantity", 10.0, 10.0 + 0.1 * sigmas};
    row.standard_error = 0.1;
    row.degrees = 31;
    row.allowance = allowance;
    row.resolution = resolution;
    return row;
}

} // namespace

TEST_CASE("a row may be off by its share of the risk")
{
    const std::vector<ExamRow> rows(100, row_off(0.0, 0.0, 1.0));
    const Judge judge(rows);
    const double most = judge.most_sigmas(31);
    CHECK(100.0 * student_tail(most, 31) == doctest::Approx(1e-3).epsilon(1e-4));
    CHECK(judge.verdict(row_off(0.99 * most, 0.0, 1.0)) == RowVerdict::passed);
    CHECK(judge.verdict(row_off(-1.01 * most, 0.0, 1.0)) == RowVerdict::wrong);
    CHECK(judge.verdict(row_off(-1.01 * most, 0.2, 1.0)) == RowVerdict::passed);
    CHECK(Judge({rows[0]}).most_sigmas(31) < most);
}

TEST_CASE("a row whose limit is wider than its resolution proves nothing, however right it is")
{
    const Judge judge({row_off(0.0, 0.0, 1.0)});
    const double limit = judge.limit(row_off(0.0, 0.3, 1.0));
    CHECK(judge.verdict(row_off(0.0, 0.3, 1.01 * limit)) == RowVerdict::passed);
    CHECK(judge.verdict(row_off(0.0, 0.3, 0.99 * limit)) == RowVerdict::vague);
}

TEST_CASE("where nothing is random only the allowance counts, and what is no number is wrong")
{
    ExamRow row = {"case", "", "", "quantity", 1.0, 1.0 + 1e-10};
    row.allowance = 1e-9;
    row.resolution = 1e-9;
    CHECK(Judge({row}).verdict(row) == RowVerdict::passed);
    row.measured = 1.0 + 1e-8;
    CHECK(Judge({row}).verdict(row) == RowVerdict::wrong);
    row.measured = std::numeric_limits<double>::quiet_NaN();
    CHECK(Judge({row}).verdict(row) == RowVerdict::wrong);
    CHECK(failures({row, row_off(0.0, 0.0, 1.0)}) == 1);
}

TEST_CASE("sigmas are counted beyond the allowance")
{
    CHECK(sigmas(row_off(3.0, 0.0, 1.0)) == doctest::Approx(3.0));
    CHECK(sigmas(row_off(-3.0, 0.1, 1.0)) == doctest::Approx(-2.0));
    CHECK(sigmas(row_off(0.5, 0.1, 1.0)) == 0.0);
}

// 1, 2, 3, 6: mean 3, squares about it 4 + 1 + 0 + 9 = 14, variance of the mean 14 / 3 / 4.
TEST_CASE("samples give mean, standard error and degrees of freedom")
{
    const ExamRow row = measured_by({"", "", "random", ""}, {1.0, 2.0, 3.0, 6.0});
    CHECK(row.measured == 3.0);
    CHECK(row.standard_error == doctest::Approx(std::sqrt(14.0 / 12.0)));
    CHECK(row.degrees == 3);
    CHECK(row.allowance == 0.0);
    CHECK(measured_by({"", "", "sobol", "", 3.0}, {1.0, 2.0}).allowance == doctest::Approx(0.015));

    const ExamRow other = measured_by({"", "", "random", ""}, {4.0, 6.0});
    const ExamRow both = compared_with(row, other);
    CHECK(both.expected == 5.0);
    CHECK(both.standard_error == doctest::Approx(std::sqrt(14.0 / 12.0 + 1.0)));
    CHECK(both.degrees == 1);
}

TEST_CASE("runs differ in seed or stretch, unless that law is broken")
{
    ExamSettings settings;
    settings.replicates = 3;
    const std::vector<ExamRun> random = exam_runs(settings, "sobol-owen");
    CHECK(random[0].seed != random[2].seed);
    CHECK(random[2].first_item == 0);
    CHECK(exam_runs(settings, "sobol")[2].first_item == 32 * settings.lines);
    settings.broken = BrokenLaw::replicates;
    CHECK(exam_runs(settings, "random")[0].seed == exam_runs(settings, "random")[2].seed);
}

TEST_CASE("the table ends with the count, and can be of failures only")
{
    const std::vector<ExamRow> rows = {row_off(0.0, 0.0, 1.0), row_off(50.0, 0.0, 1.0)};
    const std::string all = exam_text(rows, false);
    const std::string failed = exam_text(rows, true);
    CHECK(all.find("passed\n") < all.find("WRONG\n"));
    CHECK(all.find("\na row fails beyond ") > all.find("WRONG\n"));
    CHECK(all.substr(all.rfind("any\n") + 4) == "1 passed, 1 failed\n");
    CHECK(failed.find("passed\n") == std::string::npos);
    CHECK(exam_text({rows[0]}, true) == "1 passed, 0 failed\n");
    CHECK(exam_csv({rows[1]}, {"version"}).substr(0, 15) == "# version\ncase,");
}

} // namespace exam_row_test
