#include "exam/exam_row.h"

#include "radiosity/student_t.h"

#include <algorithm>
#include <cmath>

namespace multipath {

Judge::Judge(const std::vector<ExamRow>& rows)
{
    const auto random = std::count_if(rows.begin(), rows.end(), [](const ExamRow& row) { return row.degrees > 0; });
    tail_ = risk / static_cast<double>(std::max<std::ptrdiff_t>(1, random));
}

double Judge::most_sigmas(int degrees) const
{
    return degrees > 0 ? student_quantile(tail_, degrees) : 0.0;
}

double Judge::limit(const ExamRow& row) const
{
    return most_sigmas(row.degrees) * row.standard_error + row.allowance;
}

RowVerdict Judge::verdict(const ExamRow& row) const
{
    if (!(std::abs(row.measured - row.expected) <= limit(row))) // also what is no number
        return RowVerdict::wrong;
    return limit(row) <= row.resolution ? RowVerdict::passed : RowVerdict::vague;
}

double sigmas(const ExamRow& row)
{
    const double deviation = row.measured - row.expected;
    const double beyond = std::abs(deviation) - row.allowance;
    return beyond <= 0.0 ? 0.0 : std::copysign(beyond / row.standard_error, deviation);
}

const char* verdict_word(RowVerdict verdict)
{
    return verdict == RowVerdict::passed ? "passed" : verdict == RowVerdict::wrong ? "WRONG" : "VAGUE";
}

std::size_t failures(const std::vector<ExamRow>& rows)
{
    const Judge judge(rows);
    const auto failed = std::count_if(rows.begin(), rows.end(),
                                      [&](const ExamRow& r) { return judge.verdict(r) != RowVerdict::passed; });
    return static_cast<std::size_t>(failed);
}

} // namespace multipath
