#include "exam/exam_table.h"

#include "export/comments.h"
#include "export/csv_text.h"
#include "scene/text_format.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

/// Two decimals, of numbers that have no room for them four digits.
std::string short_number(double value)
{
    return format(std::abs(value) < 1000.0 ? "%.2f" : "%.1e", value);
}

std::string row_text(const ExamRow& row, RowVerdict verdict)
{
    const double off = sigmas(row);
    const bool random = row.degrees > 0;
    return format("%-14s %-11s %-15s %-36s %11.6g %11.6g ", row.topic.c_str(), row.method.c_str(), row.sequence.c_str(),
                  row.quantity.c_str(), row.expected, row.measured) +
           (random ? format("%9.2g ", row.standard_error) : format("%9s ", "-")) +
           (random && std::isfinite(off) ? format("%7s", short_number(off).c_str()) : format("%7s", "-")) + "  " +
           verdict_word(verdict) + "\n";
}

/// For the random rows with the fewest runs.
std::string limit_text(const std::vector<ExamRow>& rows, const Judge& judge)
{
    double most = 0.0;
    for (const ExamRow& row : rows)
        most = std::max(most, judge.most_sigmas(row.degrees));
    return most == 0.0 ? ""
                       : format("a row fails beyond %.2f sigmas: a right program has a chance of %g to fail any\n",
                                most, Judge::risk);
}

} // namespace

std::string exam_text(const std::vector<ExamRow>& rows, bool only_failed)
{
    const Judge judge(rows);
    std::string text;
    for (const ExamRow& row : rows) {
        const RowVerdict verdict = judge.verdict(row);
        if (verdict != RowVerdict::passed || !only_failed)
            text += row_text(row, verdict);
    }
    if (!only_failed)
        text += limit_text(rows, judge);
    if (!text.empty())
        text = format("%-14s %-11s %-15s %-36s %11s %11s %9s %7s  %s\n", "case", "method", "sequence", "quantity",
                      "expected", "measured", "std error", "sigmas", "verdict") +
               text;
    const std::size_t failed = failures(rows);
    return text + format("%zu passed, %zu failed\n", rows.size() - failed, failed);
}

std::string exam_csv(const std::vector<ExamRow>& rows, const std::vector<std::string>& comments)
{
    const Judge judge(rows);
    std::string csv = comment_lines(comments);
    csv += "case,method,sequence,quantity,expected,measured,standard_error,sigmas,limit,verdict\n";
    for (const ExamRow& row : rows) {
        const bool random = row.degrees > 0;
        const double off = sigmas(row);
        for (const std::string& name : {row.topic, row.method, row.sequence, row.quantity})
            csv += csv_field(name) + ",";
        csv += format("%.17g,%.17g,", row.expected, row.measured) +
               (random ? format("%.17g", row.standard_error) : "") + "," +
               (random && std::isfinite(off) ? format("%.4g", off) : "") +
               format(",%.4g,%s\n", judge.limit(row), verdict_word(judge.verdict(row)));
    }
    return csv;
}

} // namespace multipath
