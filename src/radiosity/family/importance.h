#pragma once

#include "sampling/sequence.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Some patches that matter more than others (Smits, Arvo, Salesin: An importance-driven radiosity algorithm, 1992).
/// Wanted is a small sum of V_i A_i (error of B_i)^2, with the weight V_i [1] of patch i.
struct Importance
{
    std::vector<double> weight; ///< V_i, per patch

    /// How much noise the power from each patch makes there, in proportion: sigma_i with rays from i in proportion to
    /// P_i sigma_i disturb the wanted patches least (I1). By so many rays from each patch, one item each from
    /// first_item on.
    std::vector<double> of_rays_from(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                     std::uint32_t rays_per_patch, int threads) const;
};

} // namespace multipath
