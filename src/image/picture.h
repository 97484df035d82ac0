#pragma once

#include "image/camera.h"
#include "image/image.h"
#include "image/render.h"
#include "image/tone_map.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// A finished picture for the screen: exposure is measured on a small preview, then the picture is rendered with white
/// where the exposure puts it (options.white is not used) and tone mapped.
ScreenImage picture(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                    const RenderOptions& options, const ToneMapOptions& tone);

} // namespace multipath
