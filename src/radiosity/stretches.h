#pragma once

#include "radiosity/solve.h"

namespace multipath {

/// solve, or solve_replicates for more than one of them, in stretches of lines: one, unless the checkpoint resumes a
/// run of fewer lines. Then another one follows for the lines that are left, with the next items of the sequence and
/// other random numbers, and the results are averaged by their lines. A share of a method that walks is a stretch of
/// its own; shares of `reuse` are for those who add them up. Throws what these throw, InputError for fewer lines than
/// the run has, and std::invalid_argument for a share of replicates.
Solution solve_in_stretches(const Scene& scene, const SolveOptions& options, int replicates,
                            const ProgressCallback& progress, Checkpoint* checkpoint, Share share);

} // namespace multipath
