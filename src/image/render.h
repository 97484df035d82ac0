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
    gather, ///< final gathering: the last reflection is computed for every pixel
};

struct RenderOptions
{
    int width = 800;
    int height = 600;
    int samples_per_pixel = 9; ///< rounded up to a square number k * k
    Shading shading = Shading::smooth;
    /// Final gathering: hemisphere rays at each point where indirect light is sampled. Twice as many shadow rays per
    /// pixel go to the sources; they are divided among the samples of the pixel, rounded up.
    int gather_rays = 64;
    bool indirect = true; ///< final gathering includes indirect light; false leaves direct light only
    int threads = 1;
    /// [W/m^2] Samples are clamped to this value before they are averaged. Pictures for a screen set it to the
    /// radiosity that is shown as white. Without the clamp, the edge of a lamp a thousand times brighter than the room
    /// would not be antialiased.
    double white = std::numeric_limits<double>::infinity();
    bool shaded_sky = false; ///< the sky is brighter towards the horizon, and below `white`; false: uniform
};

/// Renders a scene with the given radiosity [W/m^2] per patch. Where a ray meets nothing, the picture is black, or
/// shows the radiosity of the sky in a scene with a sky. The backs of one-sided surfaces are transparent. With final
/// gathering, `radiosity` must be a solution, whose last reflection is computed anew. The result does not depend on the
/// number of threads. Throws SettingsError for an invalid camera or picture size (PixelRays).
Image render(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera, const RenderOptions& options);

/// Options for the conversion of radiosity to brightness on the screen.
struct ToneMapOptions
{
    ToneOperator tone = ToneOperator::reinhard;
    double exposure = 0.0; ///< [stops] the automatic or given scale is multiplied by 2^exposure
    /// [m^2/W] Factor from radiosity to the tone operator's input; chosen by automatic_exposure() if absent.
    std::optional<double> scale = std::nullopt;
};

/// [m^2/W] The factor from radiosity to the input of the tone operator that picture() uses: the given scale or that of
/// automatic_exposure(), times 2^exposure.
double picture_scale(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                     const RenderOptions& options, const ToneMapOptions& tone);

/// Renders a tone-mapped picture for the screen. options.white and options.shaded_sky are ignored: samples are clamped
/// to the radiosity that the tone operator shows as white at this exposure, and the sky is shaded. Throws like
/// render().
ScreenImage picture(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                    const RenderOptions& options, const ToneMapOptions& tone);

} // namespace multipath
