#pragma once

#include "radiosity/run/solve.h"
#include "selftest/known_scenes.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// A measured value and its expected value: one row of the table that `selftest` prints. All numbers but `degrees` have
/// the unit of the quantity.
struct Check
{
    std::string topic;    ///< name of the known scene ("furnace"), or the kind of comparison ("power", "agreement")
    std::string method;   ///< name of the method that solved the scene
    std::string sequence; ///< sequence of the runs; "all" if the check covers the runs of all sequences
    std::string quantity; ///< name of the quantity, with its unit
    double expected = 0.0;
    double measured = 0.0;       ///< mean of independent runs, or a deterministic value
    double standard_error = 0.0; ///< of `measured`; 0 for a deterministic value
    int degrees = 0;             ///< degrees of freedom of the standard error; 0 for a deterministic value
    /// Largest systematic deviation that is acceptable: rounding, unshot power (emitted or reflected, but not yet sent
    /// on at the end of a run), and the common error of runs whose sequence is not randomised.
    double allowance = 0.0;
    /// Smallest deviation that the check must be able to detect. A check with a larger SignificanceTest::limit() is
    /// inconclusive.
    double resolution = 0.0;
};

enum class CheckOutcome {
    passed,
    wrong,        ///< farther from the expected value than the limit, or not a number
    inconclusive, ///< the limit is larger than the resolution
};

/// Two-sided t tests of all checks of a table. The probability that a correct program exceeds the limit of at least one
/// check is at most `risk`. Every random check gets an equal part of `risk` (Bonferroni correction).
class SignificanceTest
{
public:
    static constexpr double risk = 1e-3;

    explicit SignificanceTest(const std::vector<Check>& checks);

    /// Largest deviation that passes, in standard errors: the quantile of Student's t distribution for these degrees of
    /// freedom; 0 for a deterministic check (0 degrees).
    double most_sigmas(int degrees) const;
    /// Largest deviation that passes: most_sigmas() standard errors plus the allowance.
    double limit(const Check& check) const;
    CheckOutcome outcome(const Check& check) const;
    /// Number of checks of the table that did not pass: wrong or inconclusive.
    std::size_t failures() const { return failures_; }

private:
    double tail_; ///< probability that a correct program exceeds the limit of one random check
    std::size_t failures_;
};

/// The part of the deviation of a check that exceeds its allowance, in standard errors and with the sign of the
/// deviation; 0 within the allowance. Infinite for a deterministic check beyond its allowance.
double sigmas(const Check& check);

/// Formats the table as text with a header. With `only_failed`, checks that passed are left out, and so is the header
/// if all passed. The last line is "N passed, N failed".
std::string checks_text(const std::vector<Check>& checks, bool only_failed);

/// Formats the table as CSV. The comments come first.
std::string checks_csv(const std::vector<Check>& checks, const std::vector<std::string>& comments);

/// The effort of a selftest.
struct SelftestSettings
{
    std::uint64_t seed = 1;
    int replicates = 32; ///< number of independent runs for each check, at least 2
    /// Number of lines of every run. A run by `gathering`, which is noisy, takes 4 times as many in
    /// known_scene_checks(), and 16 times as many in scene_checks().
    std::uint64_t lines = 1 << 15;
    int threads = 1;
};

/// Solves every scene by every method with every sequence of the selftest (SequenceKind::in_selftest), and compares the
/// results with the known answers. Also checks that no power is gained or lost. The checks come scene by scene, and for
/// each scene method by method. They do not depend on the number of threads. `progress` gets the finished share of the
/// work.
std::vector<Check> known_scene_checks(const std::vector<KnownScene>& scenes, const SelftestSettings& settings,
                                      const ProgressCallback& progress);

/// Solves a scene without known answers by every method, with the sequence sobol-owen. Checks for each method that no
/// power is gained or lost, that the sources emit their power, and that no patch reflects negative power. The power
/// that each of the brightest materials reflects (at most four, those that reflect most) must agree with the result of
/// local Monte Carlo. `progress` gets the finished share of the work.
std::vector<Check> scene_checks(const Scene& scene, const SelftestSettings& settings, const ProgressCallback& progress);

} // namespace multipath
