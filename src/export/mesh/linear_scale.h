#pragma once

#include "scene/rgb.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// [m^2/W] Scale from radiosity [W/m^2] to linear colours, which are clipped at 1. The scale is the largest at which no
/// channel exceeds 1 on 99 % of the area, with every texture taken as white. If the brightest channel would then reach
/// 0.18, middle grey, on less than half of the area although more than half is lit, the scale is raised until it does;
/// then more than 1 % of the area is clipped. The area is that of all patches except sources and sky (only except the
/// sky, if everything emits). Returns 1 if at most 1 % of the area is lit. Independent of any camera, unlike the scale
/// of a picture.
double linear_scale(const Scene& scene, const std::vector<Rgb>& radiosity);

} // namespace multipath
