#pragma once

#include "geometry/first_hits.h"
#include "sampling/sequence.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Rays from one point, made from items and traced together, which is faster than one by one. Its memory serves again.
class RayFan
{
public:
    std::vector<Item> items; ///< one per ray, in whatever way rays are made from them
    std::vector<Line> rays;

    /// What the rays meet first, if they leave the surface on which the point lies through its front.
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
