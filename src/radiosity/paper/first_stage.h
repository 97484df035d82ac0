#pragma once

#include "radiosity/paper/extended_first_shot.h"
#include "radiosity/run/solve_options.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// N_l / N_g, local lines per global line, for the methods that shoot first: the ratio that the user has set, else the
/// optimum for the scene (optimal_ratio), or 1 where there is no optimum.
double ratio_for(const Scene& scene, const SolveOptions& options);

/// The stage before the global lines: the first shot, or the extended first shot, as the method demands. The rays take
/// the items of the sequence from first_item on. Returns the passes, none for a method without a first shot. Throws
/// SettingsError if the first pass alone needs more rays of power_by_line than the run has lines.
std::vector<ShotPass> shoot_first(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                  const SolveOptions& options, const RunControl& run, PowerState& state,
                                  const PassObserver& observe = {});

} // namespace multipath
