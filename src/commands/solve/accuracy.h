#pragma once

#include "cli/options/command_line.h"
#include "radiosity/run/replicates.h"

#include <cstdint>
#include <optional>

namespace multipath {

/// The accuracy that the user asks for.
struct Accuracy
{
    int replicates = 1;
    std::optional<double> tolerance;         ///< [1] root of the relative total mean square error (MSE) to reach
    std::optional<double> patch_error;       ///< [1] root of the relative MSE that the patches cause, once known
    std::optional<double> seconds;           ///< [s] time until all is solved
    std::optional<std::uint64_t> most_lines; ///< limit of lines for the last round; only with a tolerance or a time

    /// True if the number of lines grows, round by round, until the tolerance or the time is reached.
    bool in_rounds() const { return tolerance || seconds; }

    /// [1] The error by patches, as root of the relative MSE, that is low enough for the tolerance: nine tenths of it,
    /// since patches take more time than lines. 0 without a tolerance.
    double patch_tolerance() const;

    /// [1] The noise, as root of the relative MSE, that is low enough for the tolerance, which must be given. It is the
    /// square root of tolerance^2 - patch_error^2 (0 if unknown), but at least what patch_tolerance() leaves. The
    /// minimum applies if the patches alone cause more error and cannot be cut further, because of options, of the
    /// limit of their number, or of the time.
    double noise_tolerance() const;
};

/// The lines of the rounds of solve_in_rounds(). They end if the tolerance is reached, or if another round, twice as
/// long as the last, would exceed the time or the lines. With a tolerance the next round has 2, 4, 8 or 16 times the
/// lines, as many as bring the noise to it if its square falls as 1 / lines.
class RoundLimit
{
public:
    /// Estimates of the error from fewer than `least_lines` lines are not trusted.
    RoundLimit(const Accuracy& accuracy, std::uint64_t least_lines) : accuracy_(accuracy), least_lines_(least_lines) {}

    /// Lines of the next round; 0 if there is to be none. To be called after each round. `seconds`: [s] since the start
    /// of the first round.
    std::uint64_t next_lines(const Round& round, double seconds);

private:
    Accuracy accuracy_;
    std::uint64_t least_lines_;
    double round_start_ = 0.0; ///< [s] end of the last round, since the start of the first
};

/// The options --adaptive, --replicates, --tolerance and --time.
OptionGroup accuracy_option_group();

/// Reads --replicates, --tolerance and --time; with a tolerance or a time also --lines, as Accuracy::most_lines. Does
/// not read --adaptive (see adaptive_patches()). Throws UsageError.
Accuracy read_accuracy(const CommandLine& line);

/// Solves once, in replicates (solve_incrementally), or in rounds until RoundLimit stops them. `shard`: the part of the
/// work to do, if the run is split over several computers. A shard requires a run without replicates, tolerance and
/// time.
Solution solve_accurately(const Scene& scene, const SolveOptions& options, const Accuracy& accuracy,
                          const ProgressCallback& progress, Checkpoint* checkpoint = nullptr, Shard shard = {});

} // namespace multipath
