#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace multipath {

/// A measured value beside the expected one: one row of the table that `selftest` prints.
struct Check
{
    std::string topic;    ///< the scene, or what is compared: "furnace"
    std::string method;   ///< of solving
    std::string sequence; ///< of the runs; "all" for a check of runs with any
    std::string quantity; ///< with its unit
    double expected = 0.0;
    double measured = 0.0;       ///< mean of independent runs, or a number without randomness
    double standard_error = 0.0; ///< of the mean
    int degrees = 0;             ///< of freedom of the standard error; 0: no randomness
    /// Largest deviation for other reasons than chance: rounding, and light that a walk leaves unshot.
    double allowance = 0.0;
    /// Least deviation that must be noticed: a check that would not notice it proves nothing.
    double resolution = 0.0;
};

enum class CheckOutcome {
    passed,
    wrong,        ///< farther from the expected value than the limit
    inconclusive, ///< the limit is wider than the resolution
};

/// Two-sided t test of all checks of a table. A correct program fails any of them with the probability `risk`, which
/// the random checks share equally (Bonferroni correction).
class SignificanceTest
{
public:
    static constexpr double risk = 1e-3;

    explicit SignificanceTest(const std::vector<Check>& checks);

    /// Quantile of Student's distribution: standard errors that a check of so many degrees of freedom may be off.
    double most_sigmas(int degrees) const;
    /// Largest deviation that passes: most_sigmas standard errors and the allowance.
    double limit(const Check& check) const;
    CheckOutcome outcome(const Check& check) const;
    std::size_t failures() const { return failures_; }

private:
    double tail_; ///< probability that one check fails
    std::size_t failures_;
};

/// Deviation beyond the allowance in standard errors, with its sign; 0 within the allowance.
double sigmas(const Check& check);

/// The table to read, with a head line, and the counts "N passed, N failed" in its last line.
std::string checks_text(const std::vector<Check>& checks, bool only_failed);

/// The table as CSV, below the comments.
std::string checks_csv(const std::vector<Check>& checks, const std::vector<std::string>& comments);

} // namespace multipath
