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

/// Sampler of the rays that leave the front of one patch.
class LocalRays
{
public:
    explicit LocalRays(const Patch& patch);

    /// The ray from a uniform point, by item[0] and item[1], in a cosine-distributed direction, by item[2] and item[3].
    Line line(const Item& item) const;

    /// The same ray, given the direction `local` about +z that square_to_cosine_hemisphere makes of item[2] and
    /// item[3].
    Line line(const Item& item, Vec3 local) const;

private:
    Surface shape_;
    ObliqueAxes axes_;
};

/// The ray of LocalRays, for a patch of which a single one is needed.
Line local_line(const Patch& patch, const Item& item);

/// Writes `count` rays: ray k leaves patches[k] and takes items[k]. The same rays as local_line, computed faster.
void local_lines(const Scene& scene, const std::uint32_t* patches, const Item* items, std::size_t count, Line* lines);

/// Traces a ray that leaves a patch of `surface`. Returns the patch that it reaches, Segment::behind or
/// Segment::outside.
std::uint32_t receiver(const Scene& scene, std::uint32_t surface, const Line& ray);

/// The patch on the side of the surface that is hit, or Segment::behind if that side has none.
std::uint32_t receiving_patch(const Scene& scene, const Hit& hit);

/// Many rays from patches, traced together in reusable buffers: the results of local_line and receiver, computed
/// faster.
struct RayBlock
{
    std::vector<std::uint32_t> patches;   ///< per ray: the patch that it leaves
    std::vector<Item> items;              ///< per ray: its item (see LocalRays)
    std::vector<std::uint32_t> receivers; ///< per ray: the patch that it reaches, Segment::behind or Segment::outside

    /// Sets `receivers`, given `patches` and `items`.
    void trace(const Scene& scene);

private:
    std::vector<std::uint32_t> surfaces_;
    std::vector<Line> lines_;
    FirstHits hits_;
};

} // namespace multipath
