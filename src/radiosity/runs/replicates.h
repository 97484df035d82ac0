#pragma once

#include "radiosity/solve.h"
#include "sampling/random.h"

#include <cstdint>
#include <functional>

namespace multipath {

/// How many lines, of all replicates together, it takes before their scatter tells the error. The solution of `reuse`
/// is not linear in what its lines found: with few per patch, all replicates err to the same side, which their scatter
/// does not show. With 8 lines per patch in each of ten replicates the error was four times what it told, with 33 one
/// and a half times, with 131 a tenth more.
std::uint64_t lines_for_error(const Scene& scene, Method method, int replicates);

/// The options of one of several independent runs: another randomisation of the sequence or, of one without any,
/// another stretch. `items`: of the sequence, from the beginning of one run to that of the next.
SolveOptions independent_run(SolveOptions options, RandomStream stream, std::uint64_t seed, std::uint64_t number,
                             std::uint64_t items);

/// The mean of `replicates` >= 2 runs with independent randomisations of the sequence (randomised_name), which share
/// the lines of the options equally, with the standard error of every patch. Throws std::invalid_argument for a
/// sequence that cannot be randomised, SettingsError for fewer lines than replicates, and what solve throws. If the
/// checkpoint stops the work, the result is that of the replicates that are finished, or of the first one as it is.
Solution solve_replicates(const Scene& scene, const Preparation& preparation, const SolveOptions& options,
                          int replicates, const ProgressCallback& progress, Checkpoint* checkpoint = nullptr);

/// What a round of lines has brought.
struct Round
{
    std::uint64_t lines = 0;            ///< of this round
    double relative_standard_error = 0; ///< [1]
};

/// Round after round of replicates, each with twice the lines of the one before and none of its randomness, for as long
/// as go_on wants. The last round that was finished is the result; Solution::all_lines counts the earlier ones too.
Solution solve_until(const Scene& scene, const SolveOptions& options, int replicates, std::uint64_t first_lines,
                     const std::function<bool(const Round&)>& go_on, const ProgressCallback& progress,
                     Checkpoint* checkpoint = nullptr);

/// solve, or solve_replicates for more than one of them, in stretches of lines: one, unless the checkpoint resumes a
/// run of fewer lines. Then another one follows for the lines that are left, with the next items of the sequence and
/// other random numbers, and the results are averaged by their lines. A share of a method that walks is a stretch of
/// its own; shares of `reuse` are for those who add them up. Throws what these throw, InputError for fewer lines than
/// the run has, and std::invalid_argument for a share of replicates.
Solution solve_in_stretches(const Scene& scene, const SolveOptions& options, int replicates,
                            const ProgressCallback& progress, Checkpoint* checkpoint, Shard shard);

} // namespace multipath
