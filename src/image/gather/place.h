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

/// A point of a surface on one of its sides.
struct Place
{
    static constexpr std::uint32_t free = Intersector::no_surface; ///< in the open, on no surface

    std::uint32_t surface = 0;
    Vec3 point;
    Vec3 normal;                           ///< unit vector on that side
    std::uint32_t patch = Scene::no_patch; ///< if it is known
};

inline Place place_of(const Scene& scene, const Hit& hit)
{
    const Surface& surface = scene.surfaces()[hit.surface];
    return {hit.surface, surface.at(hit.u, hit.v), hit.front ? surface.normal() : -surface.normal(),
            scene.patch_at(hit.surface, hit.u, hit.v, hit.front)};
}

/// Rays from one point, made from items and traced together, which is faster than one by one. Keeps its memory for the
/// next point.
class RayFan
{
public:
    std::vector<Item> items; ///< one per ray, in whatever way rays are made from them
    std::vector<Line> rays;

    /// First hits of the rays, which leave the surface on which the point lies through its front.
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
