#pragma once

#include "image/camera.h"
#include "image/image.h"
#include "image/tone_map.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <limits>
#include <optional>
#include <vector>

namespace multipath {

enum class Shading {
    flat,   ///< one colour per patch
    smooth, ///< radiosity interpolated between patches (SmoothShading)
    gather, ///< final gathering: the last reflection is computed for every pixel (FinalGather)
};

struct RenderOptions
{
    int width = 800;
    int height = 600;
    int samples_per_pixel = 9; ///< rounded up to a square number
    Shading shading = Shading::smooth;
    /// Final gathering: rays per pixel for indirect light, and twice as many to the sources, divided among its samples.
    int gather_rays = 64;
    bool indirect = true; ///< final gathering includes indirect light
    int threads = 1;
    /// [W/m^2] Samples are clamped to this value before they are averaged. Pictures for a screen set it to the
    /// radiosity shown as white; otherwise the edge of a lamp a thousand times brighter than the room would not be
    /// antialiased.
    double white = std::numeric_limits<double>::infinity();
};

/// Renders a scene with the given radiosity [W/m^2] per patch; black where a ray meets nothing. The backs of one-sided
/// surfaces are transparent. With final gathering, `radiosity` must be a solution; its last reflection is computed
/// anew. The result does not depend on the number of threads. Throws SettingsError for an invalid camera or picture
/// size (PixelRays).
Image render(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera, const RenderOptions& options);

/// Options for the conversion of radiosity to brightness on the screen.
struct ToneMapOptions
{
    ToneOperator tone = ToneOperator::reinhard;
    double exposure = 0.0; ///< [stops] added to the automatic or given scale
    /// [m^2/W] Factor from radiosity to the operator's input; chosen by automatic_scale() if absent.
    std::optional<double> scale = std::nullopt;
};

/// Options for a small preview of the same picture, flat-shaded with one sample per pixel, to measure the exposure on.
RenderOptions preview_options(RenderOptions options);

/// [m^2/W] Factor from radiosity to the input of the tone operator in picture(): the given or automatic scale, times
/// 2^exposure.
double picture_scale(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                     const RenderOptions& options, const ToneMapOptions& tone);

/// Renders a tone-mapped picture for the screen. options.white is not used: samples are clamped to the radiosity that
/// the tone operator shows as white at this exposure.
ScreenImage picture(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                    const RenderOptions& options, const ToneMapOptions& tone);

} // namespace multipath
