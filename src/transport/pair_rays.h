#pragma once

#include "sampling/sequence.h"
#include "scene/scene.h"
#include "transport/exchange_estimate.h"
#include "transport/line_counter.h"

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
/// `crossing_area`.
ExchangeEstimate refined_by_rays(ExchangeEstimate estimate, const Scene& scene, const PairMatrix<float>& unoccluded,
                                 double crossing_area, const std::vector<Rgb>& radiosity, const Sequence& sequence,
                                 const PairRays& plan, int threads, const LineCounter& count_lines);

} // namespace multipath
