#pragma once

#include "sampling/sequence.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Importance of the patches (Smits, Arvo, Salesin: An importance-driven radiosity algorithm, 1992). The goal is a
/// small sum of w_i A_i (error of B_i)^2, where w_i [1] is the weight of patch i.
struct Importance
{
    std::vector<double> weight; ///< w_i, per patch

    /// Relative noise sigma_i that the power from each patch i causes in the important patches (I1). With rays from
    /// patch i in proportion to P_i sigma_i, the weighted error is smallest. Estimated by `rays_per_patch` rays from
    /// each patch, with one item each from first_item on.
    std::vector<double> noise_factors(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                      std::uint32_t rays_per_patch, int threads) const;
};

} // namespace multipath
