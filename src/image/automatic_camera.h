#pragma once

#include "geometry/vec3.h"
#include "image/camera.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// A camera that shows most of the scene well: from inside a closed room, from behind a wall (looked through, as the
/// backs of one-sided surfaces are) of one too small to step back in, or from outside through an open side. `aspect` is
/// the picture's width / height; `up` must be finite and not zero (SettingsError). `radiosity` [W/m^2] per patch tells
/// where light is to be seen; without it all surfaces count as lit. The same scene and light always give the same
/// camera.
Camera automatic_camera(const Scene& scene, double aspect, Vec3 up = {0.0, 1.0, 0.0},
                        const std::vector<Rgb>& radiosity = {});

} // namespace multipath
