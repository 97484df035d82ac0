#pragma once

#include "scene/scene.h"
#include "transport/exchange/pair_counts.h"

#include <cstdint>

namespace multipath {

/// [1] For two patches of opposite orientation in one plane: the share of their overlap where their fronts face each
/// other across a gap of no width, like the bottom of a box and the floor below it, also where faces of other solids
/// lie between them. 0 if they are back to back, like the two faces of a thin sheet, or do not overlap. To decide, rays
/// leave the smaller patch at up to 16 points that both contain, or at up to 1024 if these do not agree.
double share_in_contact(const Scene& scene, std::uint32_t a, std::uint32_t b);

/// The exchange area A_i F_ij [m^2] of every pair of patches without regard to obstacles (exchange_area, (F1) in
/// docs/equations.md). It is zero for patches of the same surface, and for coincident patches
/// where they are not in contact. The bits do not depend on the number of threads.
PairMatrix<float> unoccluded_exchange(const Scene& scene, int threads);

} // namespace multipath
