#pragma once

#include "geometry/vec3.h"
#include "image/camera.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// Finds a camera that shows most of the scene well. Without daylight the camera stands inside a closed room or outside
/// an open one; if a closed room is small, outside a wall, whose back is transparent (VisibleHits). In daylight it
/// stands in a room or courtyard if there is one, otherwise outdoors, around all that rises above the ground. `aspect`:
/// width / height of the picture. `radiosity`: [W/m^2] per patch, which determines the lit surfaces and the exposure;
/// without it all surfaces count as lit. Deterministic. Throws SettingsError if `up` is zero or not finite.
Camera automatic_camera(const Scene& scene, double aspect, Vec3 up = {0.0, 1.0, 0.0},
                        const std::vector<Rgb>& radiosity = {});

} // namespace multipath
