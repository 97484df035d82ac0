#pragma once

#include "geometry/intersector/hit_lists.h"
#include "geometry/intersector/intersector.h"
#include "sampling/sequence.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// A bundle of rays from one surface. Tracing them together is faster than one by one. Holds reusable buffers: use one
/// object per thread.
class RayFan
{
public:
    std::vector<Item> items; ///< one item (a point of the sequence, sequence.h) per ray, for rays of a sequence
    std::vector<Line> rays;

    /// The first hit of each ray in `rays`. The rays start on `surface`, or in free space (Intersector::no_surface).
    /// The reference is valid until the next call.
    const FirstHits& trace(const Scene& scene, std::uint32_t surface)
    {
        from_.assign(rays.size(), surface);
        scene.intersector().closest_hits_from(from_.data(), rays.data(), rays.size(), hits_);
        return hits_;
    }

private:
    std::vector<std::uint32_t> from_;
    FirstHits hits_;
};

} // namespace multipath
