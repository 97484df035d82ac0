#pragma once

#include "geometry/surface.h"
#include "geometry/vec3.h"

#include <vector>

namespace multipath {

/// [1] Irradiance at a point with this unit normal from a lamp of radiosity 1 behind opaque surfaces, exactly: the
/// lamp's polygon without the shadows of the blockers and what lies below the horizon, each part by Lambert's formula.
/// The point lies in the plane of no blocker.
double irradiance_past(const std::vector<Surface>& blockers, const Surface& lamp, Vec3 point, Vec3 normal);

} // namespace multipath
