#include "selftest/check.h"

#include "export/csv_text.h"
#include "radiosity/statistics.h"
#include "scene/text/text_format.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

std::string outcome_word(CheckOutcome outcome)
{
    switch (outcome) {
    case CheckOutcome::passed:
        return "passed";
    case CheckOutcome::wrong:
        return "WRONG";
    default:
        return "INCONCLUSIVE";
    }
}

/// A number with two decimals, or in exponential notation from 1000 on.
std::string short_number(double value)
{
    return format(std::abs(value) < 1000.0 ? "%.2f" : "%.1e", value);
}

std::string check_text(const Check& check, CheckOutcome outcome)
{
    const double off = sigmas(check);
    const bool random = check.degrees > 0;
    return format("%-14s %-10s %-15s %-32s %11.6g %11.6g ", check.topic.c_str(), check.method.c_str(),
                  check.sequence.c_str(), check.quantity.c_str(), check.expected, check.measured) +
           (random ? format("%9.2g ", check.standard_error) : format("%9s ", "-")) +
           (random && std::isfinite(off) ? format("%7s", short_number(off).c_str()) : format("%7s", "-")) + "  " +
           outcome_word(outcome) + "\n";
}

/// States the widest limit of the table, that of the checks with the fewest runs.
std::string limit_text(const std::vector<Check>& checks, const SignificanceTest& test)
{
    double most = 0.0;
    for (const Check& check : checks)
        most = std::max(most, test.most_sigmas(check.degrees));
    return most == 0.0
               ? ""
               : format(
                     "a check fails beyond %.2f sigmas; a correct program fails any of them with a probability of %g\n",
                     most, SignificanceTest::risk);
}

} // namespace

SignificanceTest::SignificanceTest(const std::vector<Check>& checks)
{
    const auto random = std::count_if(checks.begin(), checks.end(), [](const Check& c) { return c.degrees > 0; });
    tail_ = risk / static_cast<double>(std::max<std::ptrdiff_t>(1, random));
    failures_ = static_cast<std::size_t>(std::count_if(
        checks.begin(), checks.end(), [&](const Check& c) { return outcome(c) != CheckOutcome::passed; }));
}

double SignificanceTest::most_sigmas(int degrees) const
{
    return degrees > 0 ? student_quantile(tail_, degrees) : 0.0;
}

double SignificanceTest::limit(const Check& check) const
{
    return most_sigmas(check.degrees) * check.standard_error + check.allowance;
}

CheckOutcome SignificanceTest::outcome(const Check& check) const
{
    if (!(std::abs(check.measured - check.expected) <= limit(check))) // also true for NaN
        return CheckOutcome::wrong;
    return limit(check) <= check.resolution ? CheckOutcome::passed : CheckOutcome::inconclusive;
}

double sigmas(const Check& check)
{
    const double deviation = check.measured - check.expected;
    const double beyond = std::abs(deviation) - check.allowance;
    return beyond <= 0.0 ? 0.0 : std::copysign(beyond / check.standard_error, deviation);
}

std::string checks_text(const std::vector<Check>& checks, bool only_failed)
{
    const SignificanceTest test(checks);
    std::string text;
    for (const Check& check : checks) {
        const CheckOutcome outcome = test.outcome(check);
        if (outcome != CheckOutcome::passed || !only_failed)
            text += check_text(check, outcome);
    }
    if (!only_failed)
        text += limit_text(checks, test);
    if (!text.empty())
        text = format("%-14s %-10s %-15s %-32s %11s %11s %9s %7s  %s\n", "case", "method", "sequence", "quantity",
                      "expected", "measured", "std error", "sigmas", "outcome") +
               text;
    return text + format("%zu passed, %zu failed\n", checks.size() - test.failures(), test.failures());
}

std::string checks_csv(const std::vector<Check>& checks, const std::vector<std::string>& comments)
{
    const SignificanceTest test(checks);
    std::string csv = comment_lines(comments);
    csv += "case,method,sequence,quantity,expected,measured,standard_error,sigmas,limit,outcome\n";
    for (const Check& check : checks) {
        const bool random = check.degrees > 0;
        const double off = sigmas(check);
        for (const std::string& name : {check.topic, check.method, check.sequence, check.quantity})
            csv += csv_field(name) + ",";
        csv += format("%.17g,%.17g,", check.expected, check.measured) +
               (random ? format("%.17g", check.standard_error) : "") + "," +
               (random && std::isfinite(off) ? format("%.4g", off) : "") +
               format(",%.4g,%s\n", test.limit(check), outcome_word(test.outcome(check)).c_str());
    }
    return csv;
}

} // namespace multipath
