#pragma once

#include "image/camera.h"
#include "image/image.h"
#include "image/render.h"
#include "image/tone_map.h"
#include "scene/scene.h"

#include <optional>
#include <vector>

namespace multipath {

/// How radiosity becomes brightness on the screen.
struct ToneMapOptions
{
    ToneOperator tone = ToneOperator::reinhard;
    double exposure = 0.0; ///< [stops] added to the automatic or given scale
    /// [m^2/W] brings radiosity to the operator's input; measured on the picture if absent
    std::optional<double> scale = std::nullopt;
};

/// The same picture small and coarse, for what is measured on it.
RenderOptions preview_options(RenderOptions options);

/// [m^2/W] The scale at which picture() shows the radiosity: the given or the measured one, exposure included.
double picture_scale(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                     const RenderOptions& options, const ToneMapOptions& tone);

/// A finished picture for the screen: exposure is measured on a small preview, then the picture is rendered with white
/// where the exposure puts it (options.white is not used) and tone mapped.
ScreenImage picture(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                    const RenderOptions& options, const ToneMapOptions& tone);

} // namespace multipath
