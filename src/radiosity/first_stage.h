#pragma once

#include "radiosity/extended_first_shot.h"
#include "radiosity/solve_options.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// N_l / N_g for the methods that shoot first: the user's ratio, or the optimum (3) for the scene, or 1 where (3) has
/// no value.
double ratio_for(const Scene& scene, const SolveOptions& options);

/// Options of the extended first shot of this run. The caller sets `lines` or `power_by_line`.
ExtendedShotOptions extended_shot(const Scene& scene, const SolveOptions& options);

/// The stage before the global lines: the passes of the (extended) first shot, none for methods without one. The rays
/// take the items from first_item on. Throws SettingsError if power_by_line needs more rays than the run has lines.
std::vector<ShotPass> shoot_first(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                  const SolveOptions& options, const RunControl& run, PowerState& state,
                                  const PassObserver& observe = {});

} // namespace multipath
