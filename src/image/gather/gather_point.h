#pragma once

#include "geometry/hit.h"
#include "geometry/intersector/hit_lists.h"
#include "geometry/intersector/intersector.h"
#include "geometry/vec3.h"
#include "sampling/sequence.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// A point that receives light: a point on one side of a surface, or a point in free space.
struct GatherPoint
{
    static constexpr std::uint32_t free = Intersector::no_surface; ///< value of `surface` in free space

    std::uint32_t surface = 0; ///< index of the surface, or `free`
    Vec3 point;
    Vec3 normal;                           ///< unit vector on the receiving side
    std::uint32_t patch = Scene::no_patch; ///< patch that contains the point; Scene::no_patch if unknown
};

/// The point of a hit, on the side of the surface that was hit.
inline GatherPoint gather_point(const Scene& scene, const Hit& hit)
{
    const Surface& surface = scene.surfaces()[hit.surface];
    return {hit.surface, surface.at(hit.u, hit.v), hit.front ? surface.normal() : -surface.normal(),
            scene.patch_at(hit.surface, hit.u, hit.v, hit.front)};
}

/// A bundle of rays from one point. Tracing them together is faster than one by one. Holds reusable buffers: use one
/// object per thread.
class RayFan
{
public:
    std::vector<Item> items; ///< one item (a point of the sequence, sequence.h) per ray
    std::vector<Line> rays;

    /// The first hit of each ray in `rays`. The rays start on `surface`, or in free space (GatherPoint::free). The
    /// reference is valid until the next call.
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
