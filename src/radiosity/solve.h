#pragma once

#include "radiosity/extended_first_shot.h"
#include "radiosity/power_state.h"
#include "radiosity/solve_options.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace multipath {

struct Solution
{
    std::vector<Rgb> radiosity; ///< [W/m^2] per patch
    PowerBalance balance;
    std::uint64_t local_lines = 0;  ///< N_l
    std::uint64_t global_lines = 0; ///< N_g, charged by (N1)
    std::uint64_t global_lines_cast = 0;
    std::vector<ShotPass> shot_passes; ///< of the (extended) first shot
};

/// Told how much of the work is done, 0 ... 1, in increasing order, from the thread that just finished a piece.
using ProgressCallback = std::function<void(double done)>;

/// The radiosity of every patch. The result is a function of scene, options and seed; not of the threads.
/// Throws InputError for a sequence with too few items or more rays by power_by_line than lines, std::invalid_argument
/// for an unknown one.
Solution solve(const Scene& scene, const SolveOptions& options, const ProgressCallback& progress);

} // namespace multipath
