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

/// For `reuse` without a table of all pairs, after gathering. Where little is lit, and brightly, its light is better
/// shot than left to global lines, which seldom come by. The more of the unshot power stands out above the threshold
/// (4), the more lines it gets, up to half of the `lines_left`; where little does, shooting it with few lines would
/// only add noise: 0. The figures were found by trying.
std::uint64_t lines_for_what_stands_out(const Scene& scene, const SolveOptions& options, const PowerState& state,
                                        std::uint64_t lines_left);

/// What comes before the global lines: the passes of the (extended) first shot as the options want them, none for the
/// methods without. Takes the items from first_item on. Throws SettingsError for more rays by power_by_line than
/// lines.
std::vector<ShotPass> shoot_first(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                  const SolveOptions& options, const RunControl& run, PowerState& state,
                                  const PassObserver& observe = {});

} // namespace multipath
