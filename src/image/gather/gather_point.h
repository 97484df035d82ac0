#pragma once

#include "geometry/hit.h"
#include "geometry/vec3.h"
#include "image/ray_fan.h"
#include "scene/scene.h"

#include <cstdint>

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

} // namespace multipath
