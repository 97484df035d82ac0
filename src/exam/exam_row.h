#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace multipath {

/// A known answer, and what the program says: one line of the exam.
struct ExamRow
{
    std::string topic;    ///< the scene or the law: "furnace"
    std::string method;   ///< of solving, or what took its place: "rays", "lines"
    std::string sequence; ///< may be empty
    std::string quantity; ///< what is measured, with its unit
    double expected = 0.0;
    double measured = 0.0;       ///< mean of independent runs, or a single number that nothing random is in
    double standard_error = 0.0; ///< of the mean
    int degrees = 0;             ///< of freedom of the standard error; 0: nothing is random
    /// What may be off for other reasons than chance: rounding, and light that a walk leaves unshot.
    double allowance = 0.0;
    /// A row that would not notice a deviation of this size proves nothing.
    double resolution = 0.0;
};

enum class RowVerdict {
    passed,
    wrong, ///< farther from the known answer than the limit
    vague, ///< the limit is wider than the resolution
};

/// Judges rows of one exam. A right program fails one of its rows by chance with a probability of `risk`, which the
/// rows share equally (Bonferroni): a row may be off by the standard error times the t that a Student's distribution
/// exceeds with probability risk / rows, and by its allowance.
class Judge
{
public:
    static constexpr double risk = 1e-3;

    explicit Judge(const std::vector<ExamRow>& rows);

    /// Standard errors that a row of so many degrees of freedom may be off.
    double most_sigmas(int degrees) const;
    double limit(const ExamRow& row) const;
    RowVerdict verdict(const ExamRow& row) const;

private:
    double tail_; ///< of one row
};

/// Standard errors by which the answer is farther from the known one than the allowance; 0 within it.
double sigmas(const ExamRow& row);

/// "passed", "WRONG", "VAGUE"
const char* verdict_word(RowVerdict verdict);

/// How many rows did not pass.
std::size_t failures(const std::vector<ExamRow>& rows);

} // namespace multipath
