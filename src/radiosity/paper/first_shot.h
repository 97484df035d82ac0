#pragma once

#include "radiosity/paper/extended_first_shot.h"

namespace multipath {

class Run;
struct SolveOptions;

/// N_l / N_g, local lines per global line, for the methods that shoot first: the ratio that the user has set, else the
/// optimum for the scene by (3), or by a pilot with options.measured_ratio; 1 where there is no optimum.
double ratio_for(const Scene& scene, const SolveOptions& options);

/// The stage before the global lines: the extended first shot, or with a single pass the first shot, as the method
/// demands; nothing for a method without one. Records the passes in the solution of the run, and their rays as local
/// lines. Throws SettingsError if the first pass alone needs more rays of power_by_line than the run has lines.
void shoot_first(Run& run, const PassObserver& observe = ignore_pass);

} // namespace multipath
