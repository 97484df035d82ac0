#pragma once

#include "geometry/hit.h"
#include "geometry/vec3.h"
#include "scene/scene.h"

#include <cstdint>

namespace multipath {

/// A point of a surface on one of its sides.
struct Place
{
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

} // namespace multipath
