#pragma once

#include "scene/scene.h"
#include "transport/pair_matrix.h"

namespace multipath {

/// A F [m^2] of every pair of patches as if nothing stood between them: see exchange_area. Zero for patches of one
/// surface, and of coincident ones that are turned away from each other. The same bits for any number of threads.
PairMatrix<float> unoccluded_exchange(const Scene& scene, int threads);

} // namespace multipath
