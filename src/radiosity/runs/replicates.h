#pragma once

#include "radiosity/solve.h"
#include "sampling/random.h"

#include <cstdint>
#include <functional>

namespace multipath {

/// Number of lines, in all replicates together, from which their scatter is a good estimate of the error. The solution
/// of `reuse` is not linear in its counts: with few lines per patch, all replicates have the same bias, and their
/// scatter does not show it. With 8 lines per patch in each of ten replicates the true error was four times the
/// estimated one, with 33 one and a half times, with 131 a tenth larger.
std::uint64_t lines_for_error_estimate(const Scene& scene, Method method, int replicates);

/// Options of run `number` of several independent runs: another randomisation of the sequence, or another section of a
/// sequence that is not randomised. `items`: number of items from the beginning of one run to that of the next.
SolveOptions independent_run(SolveOptions options, RandomStream stream, std::uint64_t seed, std::uint64_t number,
                             std::uint64_t items);

/// The mean of `replicates` >= 2 runs with independent randomisations of the sequence (randomised_name), which divide
/// the lines of the options equally, with the standard error of every patch. If the checkpoint stops the work, returns
/// the mean of the finished replicates, or the first one so far. Throws std::invalid_argument for a sequence that
/// cannot be randomised, SettingsError for fewer lines than replicates, and what solve() throws.
Solution solve_replicates(const Scene& scene, const Preparation& preparation, const SolveOptions& options,
                          int replicates, const ProgressCallback& progress, Checkpoint* checkpoint = nullptr);

/// Result of one round of lines.
struct Round
{
    std::uint64_t lines = 0;            ///< in this round
    double relative_standard_error = 0; ///< [1]
};

/// Rounds of replicates, each with twice the lines of the previous one and independent of it, while go_on returns true.
/// Returns the last finished round; Solution::all_lines includes the earlier ones.
Solution solve_in_rounds(const Scene& scene, const SolveOptions& options, int replicates, std::uint64_t first_lines,
                         const std::function<bool(const Round&)>& go_on, const ProgressCallback& progress,
                         Checkpoint* checkpoint = nullptr);

/// Solves with all lines of the options, by solve(), or by solve_replicates() for more than one replicate. If the
/// checkpoint resumes a run of fewer lines, the remaining lines form a second run with the next items of the sequence
/// and other random numbers, and the two results are averaged by their lines. A shard of an averaged method is such a
/// run of its own; shards of `reuse` must be added up (add_up_shards). Throws what these throw, InputError if the
/// resumed run has more lines than requested, and std::invalid_argument for a shard of replicates.
Solution solve_incrementally(const Scene& scene, const SolveOptions& options, int replicates,
                             const ProgressCallback& progress, Checkpoint* checkpoint, Shard shard);

} // namespace multipath
