#pragma once

#include "parallel/run_control.h"
#include "sampling/sequence.h"
#include "scene/scene.h"
#include "transport/exchange_estimate.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Rays between the points of pairs of patches, to learn how much of each other they see.
struct PairRays
{
    std::uint64_t first_item = 0; ///< of the sequence; one item per ray: a point on each of the two patches
    std::uint64_t rays = 0;       ///< in all
    std::uint64_t seed = 0;       ///< of the rounding to whole rays
};

/// Casts rays where they lower the error (1) most: between pairs that exchange much light and are neither surely free
/// nor surely hidden; `radiosity` [W/m^2] need only be roughly right. The estimate must come from lines of
/// `crossing_area`; it gets better row by row, and a checkpoint must hold it besides what this function makes it hold.
void refine_by_rays(ExchangeEstimate& estimate, const Scene& scene, const PairMatrix<float>& unoccluded,
                    double crossing_area, const std::vector<Rgb>& radiosity, const Sequence& sequence,
                    const PairRays& plan, const RunControl& run);

} // namespace multipath
