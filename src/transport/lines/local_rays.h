#pragma once

#include "geometry/intersector/hit_lists.h"
#include "geometry/line.h"
#include "sampling/sequence.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// The ray of one item that leaves the front of a patch: item[0] and item[1] choose its start, uniform on the patch,
/// item[2] and item[3] its cosine-distributed direction.
Line local_line(const Patch& patch, const Item& item);

/// Writes `count` rays to `lines`: ray k leaves patches[k] and takes items[k]. They are the same as those of
/// local_line, computed faster.
void local_lines(const Scene& scene, const std::uint32_t* patches, const Item* items, std::size_t count, Line* lines);

/// Traces a ray that leaves a patch of `surface`. Returns the patch that the ray reaches, Segment::behind if it meets a
/// side without a patch, or Segment::outside if it meets nothing.
std::uint32_t receiver(const Scene& scene, std::uint32_t surface, const Line& ray);

/// The patch on the side of the surface that a ray hits, or Segment::behind if that side has none.
std::uint32_t receiving_patch(const Scene& scene, const Hit& hit);

/// Number of rays in a block that a thread traces at a time.
constexpr std::uint64_t rays_per_block = 4096;

/// Many rays from patches, traced together in reusable buffers. The results are those of local_line and receiver,
/// computed faster.
struct RayBlock
{
    std::vector<std::uint32_t> patches;   ///< per ray: the patch that the ray leaves
    std::vector<Item> items;              ///< per ray: the item that makes it (local_line)
    std::vector<std::uint32_t> receivers; ///< per ray: the result of receiver()

    /// Sets `receivers`, given `patches` and `items` of equal length.
    void trace(const Scene& scene);

private:
    std::vector<std::uint32_t> surfaces_;
    std::vector<Line> lines_;
    FirstHits hits_;
};

} // namespace multipath
