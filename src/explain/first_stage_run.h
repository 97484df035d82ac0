#pragma once

#include "radiosity/paper/extended_first_shot.h"
#include "radiosity/run/solve_options.h"
#include "transport/lines/global_lines.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Figures of a run up to its global pass, or up to the directions of transillumination.
struct FirstStageRun
{
    std::vector<ShotPass> passes;     ///< of the first shot; none for methods without one
    std::uint64_t local_lines = 0;    ///< N_l, number of rays of the first shot
    std::uint64_t lines_charged = 0;  ///< N_g (N1), number of lines that meet the scene's box, in expectation
    std::uint64_t lines_cast = 0;     ///< N_cast (N1), number of lines cast
    double crossings_per_area = 0.0;  ///< [1/m^2] expected crossings per area of a patch, from either side (G1)
    std::uint64_t unshot_patches = 0; ///< number of patches with unshot power, which have a forecast
    Rgb unshot;                       ///< [W] unshot power of all patches
};

/// Runs the first stage as solve does.
FirstStageRun run_first_stage(const Scene& scene, const Sequence& sequence, const GlobalLines& lines,
                              const SolveOptions& options, PowerState& state);

} // namespace multipath
