#pragma once

#include "scene/scene.h"

#include <vector>

namespace multipath {

/// [m^2/W] The scale for linear colours that must not exceed 1: no channel does on 99 % of the area that does not emit,
/// or of all area if everything emits. The rest are spots of lamps on what is next to them. From the radiosity [W/m^2]
/// per patch; 1 for a dark scene. Unlike a picture's it depends on no camera.
double linear_scale(const Scene& scene, const std::vector<Rgb>& radiosity);

} // namespace multipath
