#pragma once

#include "image/camera.h"
#include "image/false_colour/quantity.h"
#include "image/image.h"
#include "image/render.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// Renders the scene with a given colour per patch (linear light, 0 ... 1), black where a ray meets nothing. There is
/// no interpolation and no exposure: options.shading and options.white are not used.
ScreenImage flat_picture(const Scene& scene, const std::vector<Rgb>& colours, const Camera& camera,
                         RenderOptions options);

/// Renders a quantity in false colours: the mean of its channels as one colour per patch, black where a patch has no
/// value, and a legend below if there is room. The scale goes from 0 to a round number at or above the 99th percentile
/// of the visible values, or above twice the 90th percentile if that is less, so that a small very bright spot does not
/// make the rest dark. If the quantity has contours, they follow the interpolated values (SmoothShading) at the numbers
/// of the legend.
ScreenImage false_colour(const Scene& scene, const Quantity& quantity, const Camera& camera, RenderOptions options);

} // namespace multipath
