#pragma once

#include "scene/scene.h"

#include <vector>

namespace multipath {

/// [m^2/W] The scale for linear colours that cannot exceed 1. On 99 % of the area that does not emit (of all area, if
/// everything emits) no channel does; but where light and dark are too far apart for that, half of this area is at
/// least at 0.18, the grey of photographers. From the radiosity [W/m^2] per patch; 1 for a dark scene. Unlike a
/// picture's scale it depends on no camera.
double linear_scale(const Scene& scene, const std::vector<Rgb>& radiosity);

} // namespace multipath
