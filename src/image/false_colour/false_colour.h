#pragma once

#include "image/camera.h"
#include "image/false_colour/quantity.h"
#include "image/image.h"
#include "image/render.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// The scene with every patch in a colour of its own (linear light, 0 ... 1), black where nothing is met. Neither
/// shaded nor exposed: options.shading and options.white are not used.
ScreenImage flat_picture(const Scene& scene, const std::vector<Rgb>& colours, const Camera& camera,
                         RenderOptions options);

/// The mean of the channels of a quantity as a colour per patch, black where a patch has no value, above a legend if
/// the picture has room for it. The scale goes from 0 to a round number at or above the 99th percentile of what is
/// seen, or twice the 90th if that is less: a small spot much brighter than the rest does not make the rest dark.
/// Contours are of the interpolated values (SmoothShading), at the numbers of the legend.
ScreenImage false_colour(const Scene& scene, const Quantity& quantity, const Camera& camera, RenderOptions options);

} // namespace multipath
