#pragma once

#include "image/camera.h"
#include "image/false_colour/quantity.h"
#include "image/image.h"
#include "image/render.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// Renders the scene with a given colour per patch (linear light, 0 ... 1). Where a ray meets nothing, the picture is
/// black, or has the colour of the sky in a scene with a sky. There is no interpolation and no exposure:
/// options.shading and options.white are ignored. Throws SettingsError like render().
ScreenImage flat_picture(const Scene& scene, const std::vector<Rgb>& colours, const Camera& camera,
                         RenderOptions options);

/// Renders a quantity in false colours: one colour per patch, for the mean of the channels of its value; black where a
/// patch has no value. The picture has the size that the options give. If there is room, the lowest rows of the picture
/// are a legend. The scale goes from 0 to a round number at or above the smaller of two values: the 99th percentile of
/// the visible values, and twice their 90th percentile unless that is 0. With the latter, a small very bright spot does
/// not make the rest dark. If the quantity has contours, contour lines follow the interpolated values (SmoothShading)
/// at the numbers of the legend. Sources get no contour lines. Throws SettingsError like render().
ScreenImage false_colour(const Scene& scene, const Quantity& quantity, const Camera& camera, RenderOptions options);

} // namespace multipath
