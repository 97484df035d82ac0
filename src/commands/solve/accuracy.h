#pragma once

#include "cli/options/command_line.h"
#include "radiosity/runs/replicates.h"

#include <cstdint>
#include <optional>

namespace multipath {

/// How well the user wants to know the result.
struct Accuracy
{
    int replicates = 1;
    std::optional<double> tolerance;         ///< [1] root of the relative total MSE to reach
    std::optional<double> patch_error;       ///< [1] the patches' part of it, once it is known
    std::optional<double> seconds;           ///< to solve for
    std::optional<std::uint64_t> most_lines; ///< of the last round, where one of these two decides

    bool in_rounds() const { return tolerance || seconds; }

    /// [1] What the tolerance leaves for the noise. Half of it where the patches' error leaves less: they are the
    /// user's choice then.
    double noise_tolerance() const;
};

/// Ends the rounds when the tolerance is reached, or where another round, twice as long as the last, would exceed the
/// time or the lines.
class RoundLimit
{
public:
    /// With fewer lines than `least_lines` an error is not believed.
    RoundLimit(const Accuracy& accuracy, std::uint64_t least_lines) : accuracy_(accuracy), least_lines_(least_lines) {}

    /// After each round, `seconds` after the start of the first one.
    bool go_on(const Round& round, double seconds);

private:
    Accuracy accuracy_;
    std::uint64_t least_lines_;
    double round_start_ = 0.0; ///< [s]
};

OptionGroup accuracy_option_group();

/// Throws UsageError.
Accuracy read_accuracy(const CommandLine& line);

/// Solves as the accuracy asks: once, in replicates, or in rounds until it is reached or would not be in time. Shares
/// are for runs without replicates.
Solution solve_accurately(const Scene& scene, const SolveOptions& options, const Accuracy& accuracy,
                          const ProgressCallback& progress, Checkpoint* checkpoint = nullptr, Shard shard = {});

} // namespace multipath
