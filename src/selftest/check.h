#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace multipath {

/// A measured value and its expected value: one row of the table that `selftest` prints.
struct Check
{
    std::string topic;    ///< the known scene ("furnace"), or the kind of comparison
    std::string method;   ///< that solved the scene
    std::string sequence; ///< of the runs; "all" if the check covers the runs of all sequences
    std::string quantity; ///< with its unit
    double expected = 0.0;
    double measured = 0.0;       ///< mean of independent runs, or a deterministic value
    double standard_error = 0.0; ///< of the mean
    int degrees = 0;             ///< degrees of freedom of the standard error; 0: deterministic
    /// Largest systematic deviation that is acceptable: rounding, and light that a walk leaves unshot.
    double allowance = 0.0;
    /// Smallest deviation that the check must be able to detect; if it cannot, it is inconclusive.
    double resolution = 0.0;
};

enum class CheckOutcome {
    passed,
    wrong,        ///< farther from the expected value than the limit
    inconclusive, ///< the limit is wider than the resolution
};

/// Two-sided t test of all checks of a table. The probability that a correct program fails at least one of them is at
/// most `risk`, of which every random check gets an equal part (Bonferroni correction).
class SignificanceTest
{
public:
    static constexpr double risk = 1e-3;

    explicit SignificanceTest(const std::vector<Check>& checks);

    /// Largest deviation that passes, in standard errors: the quantile of Student's distribution for these degrees of
    /// freedom; 0 for deterministic checks.
    double most_sigmas(int degrees) const;
    /// Largest deviation that passes: most_sigmas standard errors plus the allowance.
    double limit(const Check& check) const;
    CheckOutcome outcome(const Check& check) const;
    std::size_t failures() const { return failures_; }

private:
    double tail_; ///< probability that a correct program fails one random check
    std::size_t failures_;
};

/// Deviation beyond the allowance, in standard errors with its sign; 0 within the allowance.
double sigmas(const Check& check);

/// The table as text with a header; the last line is "N passed, N failed".
std::string checks_text(const std::vector<Check>& checks, bool only_failed);

/// The table as CSV, after the comments.
std::string checks_csv(const std::vector<Check>& checks, const std::vector<std::string>& comments);

} // namespace multipath
