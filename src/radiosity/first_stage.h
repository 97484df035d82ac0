#pragma once

#include "radiosity/extended_first_shot.h"
#include "radiosity/solve_options.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// N_l / N_g for the methods that shoot first: the user's, or the optimum (3) for the scene.
double ratio_for(const Scene& scene, const SolveOptions& options);

/// The options of the run that an extended first shot follows; its lines, or their power, are left to the caller.
ExtendedShotOptions extended_shot(const Scene& scene, const SolveOptions& options);

/// What comes before the global lines: the passes of the (extended) first shot as the options want them, none for the
/// methods without. Takes the items from first_item on. Throws SettingsError for more rays by power_by_line than
/// lines.
std::vector<ShotPass> shoot_first(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                  const SolveOptions& options, const RunControl& run, PowerState& state,
                                  const PassObserver& observe = {});

} // namespace multipath
