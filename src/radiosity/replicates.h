#pragma once

#include "radiosity/solve.h"

#include <cstdint>
#include <functional>

namespace multipath {

/// The mean of `replicates` >= 2 runs with independent randomisations of the sequence (randomised_name), which share
/// the lines of the options equally, with the standard error of every patch. Throws std::invalid_argument for a
/// sequence that cannot be randomised, InputError like solve, and for fewer lines than replicates. If the checkpoint
/// stops the work, the result is that of the replicates that are finished, or of the first one as it is.
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

} // namespace multipath
