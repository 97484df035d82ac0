#pragma once

#include "geometry/first_hits.h"
#include "geometry/line.h"
#include "sampling/sequence.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Many rays from patches, traced together: what local_line and receiver find, faster. The memory serves again.
struct RayBlock
{
    std::vector<std::uint32_t> patches;   ///< from which the rays leave
    std::vector<Item> items;              ///< numbers of each ray (see LocalRays)
    std::vector<std::uint32_t> receivers; ///< of each ray a patch, or Segment::behind or Segment::outside

    /// Finds the receivers of all rays.
    void trace(const Scene& scene);

private:
    std::vector<std::uint32_t> surfaces_;
    std::vector<Line> lines_;
    FirstHits hits_;
};

} // namespace multipath
