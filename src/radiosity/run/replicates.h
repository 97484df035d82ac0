#pragma once

#include "radiosity/run/solve.h"
#include "sampling/random.h"

#include <cstdint>
#include <functional>

namespace multipath {

/// Number of lines, in all replicates together, from which the scatter of the replicates is a good estimate of the
/// error; 0 for all methods but `reuse`. The solution of `reuse` is not linear in its counts: with few lines per patch,
/// all replicates have the same bias, which their scatter does not show. With 8 lines per patch in each of ten
/// replicates the true error was four times the estimated one, with 33 lines one and a half times, with 131 lines a
/// tenth larger.
std::uint64_t lines_for_error_estimate(const Scene& scene, Method method, int replicates);

/// Options of run `number` of several independent runs. Each run has a seed of its own, derived from `stream` and
/// `seed`. If the sequence is not randomised, each run also has its own section: run `number` skips `number` * `items`
/// items in addition to options.skip.
SolveOptions independent_run(SolveOptions options, RandomStream stream, std::uint64_t seed, std::uint64_t number,
                             std::uint64_t items);

/// The mean of `replicates` >= 2 runs with independent randomisations of the sequence (randomised_name), which divide
/// the lines of the options equally, with the standard error of every patch. If the checkpoint stops the work, returns
/// the mean of the finished replicates, which has standard errors only if they are two or more; if none is finished,
/// returns the partial result of the first one. Throws std::invalid_argument for a sequence that cannot be randomised,
/// SettingsError for fewer lines than replicates, and what solve() throws.
Solution solve_replicates(const Scene& scene, const Preparation& preparation, const SolveOptions& options,
                          int replicates, const ProgressCallback& progress, Checkpoint* checkpoint = nullptr);

/// Result of one round of lines.
struct Round
{
    std::uint64_t lines = 0;            ///< number of lines of this round, in all replicates together
    double relative_standard_error = 0; ///< [1] Solution::relative_standard_error
};

/// Rounds of `replicates` >= 2 replicates. The first round has first_lines lines in total; options.lines has no effect.
/// Each later round is independent of all earlier ones. next_lines(round) is called after each round, and returns the
/// number of lines of the next one, or 0 to end the work. Returns the last finished round;
/// Solution::all_lines includes the lines of the earlier ones. If the checkpoint stops the first round, returns the
/// replicates so far. Throws what solve_replicates() and prepare() throw.
Solution solve_in_rounds(const Scene& scene, const SolveOptions& options, int replicates, std::uint64_t first_lines,
                         const std::function<std::uint64_t(const Round&)>& next_lines, const ProgressCallback& progress,
                         Checkpoint* checkpoint = nullptr);

/// Solves with all lines of the options, by solve(), or by solve_replicates() for more than one replicate. If the
/// checkpoint resumes a run of fewer lines, the remaining lines form a second run with the next items of the sequence
/// and other random numbers, and the two results are averaged by their lines (combined()). If the checkpoint stops the
/// first run, returns its partial result; if it stops the second run, the result of the first run alone.
///
/// A shard of a method with Shards::averaged is a run of its own, with its part of the lines and items. The shards of
/// `reuse` divide the work of one run, and must be added up (add_up_shards).
///
/// Throws what prepare() and these functions throw, InputError if the resumed run has more lines than requested, and
/// std::invalid_argument for a shard of replicates.
Solution solve_incrementally(const Scene& scene, const SolveOptions& options, int replicates,
                             const ProgressCallback& progress, Checkpoint* checkpoint, Shard shard);

} // namespace multipath
