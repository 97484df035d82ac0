#pragma once

#include "image/camera.h"
#include "image/render.h"
#include "image/tone_map.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// [m^2/W] The automatic scale for a picture of a scene: that of a preview (automatic_scale()), but not so large that
/// more than an eighth of the surfaces in it, lamps apart, are white. Neither the sky counts, nor what is outdoors
/// while the camera is indoors. `radiosity`: [W/m^2] per patch. Does not depend on the number of threads. Throws
/// SettingsError for an invalid camera or picture size (PixelRays).
double automatic_exposure(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                          const RenderOptions& options, ToneOperator tone);

} // namespace multipath
