#pragma once

#include "geometry/surface.h"
#include "geometry/vec3.h"

#include <vector>

namespace multipath {

/// [1] Exact irradiance at a point with this unit normal from a lamp of radiosity 1 that opaque surfaces occlude in
/// part; 0 behind the lamp, which emits at its front. The polygon of the lamp is clipped by the horizon (the plane
/// through the point with the normal) and by the shadow of every blocker, and the visible parts are integrated by
/// Lambert's formula. The point must not lie in the plane of a blocker.
double irradiance_past(const std::vector<Surface>& blockers, const Surface& lamp, Vec3 point, Vec3 normal);

} // namespace multipath
