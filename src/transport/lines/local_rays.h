#pragma once

#include "geometry/intersector/hit_lists.h"
#include "geometry/line.h"
#include "sampling/sequence.h"
#include "sampling/warp.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// The rays that leave one patch.
class LocalRays
{
public:
    explicit LocalRays(const Patch& patch);

    /// The ray from a uniform point (item[0], item[1]) in a cosine-distributed direction (item[2], item[3]).
    Line line(const Item& item) const;

    /// The same for a direction found elsewhere: item[2], item[3] on the hemisphere about +z.
    Line line(const Item& item, Vec3 local) const;

private:
    Surface shape_;
    ObliqueAxes axes_;
};

/// The same for a single ray.
Line local_line(const Patch& patch, const Item& item);

/// The same for many rays, faster: number k from patches[k] by items[k].
void local_lines(const Scene& scene, const std::uint32_t* patches, const Item* items, std::size_t count, Line* lines);

/// Where the ray from a patch arrives: a patch, or Segment::behind or Segment::outside.
std::uint32_t receiver(const Scene& scene, std::uint32_t surface, const Line& ray);

/// The patch that is met, or Segment::behind.
std::uint32_t receiving_patch(const Scene& scene, const Hit& hit);

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
