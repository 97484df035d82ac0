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
    flat,   ///< every patch in one colour
    smooth, ///< interpolated between patches
    gather, ///< the last reflection computed for every pixel
};

struct RenderOptions
{
    int width = 800;
    int height = 600;
    int samples_per_pixel = 9; ///< rounded up to a square
    Shading shading = Shading::smooth;
    int gather_rays = 64; ///< per pixel for indirect light, and twice as many to the sources, shared by its samples
    bool indirect = true; ///< of gathering: also light that has been reflected before
    int threads = 1;
    /// [W/m^2] Samples brighter than this count as this. A picture for a screen sets what the screen shows as white:
    /// the rim of a lamp a thousand times brighter than the room would otherwise have no intermediate steps.
    double white = std::numeric_limits<double>::infinity();
};

/// The image of a scene with the given radiosity [W/m^2] per patch; black where a ray meets nothing. Rays pass through
/// sides that do not exist. Gathering takes `radiosity` for a solution and computes its last reflection anew. The same
/// bytes for any number of threads. Throws SettingsError for an impossible camera or picture size.
Image render(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera, const RenderOptions& options);

/// The conversion of radiosity to brightness on the screen.
struct ToneMapOptions
{
    ToneOperator tone = ToneOperator::reinhard;
    double exposure = 0.0; ///< [stops] added to the automatic or given scale
    /// [m^2/W] brings radiosity to the operator's input; measured on the picture if absent
    std::optional<double> scale = std::nullopt;
};

/// The same picture small and coarse, for measuring the exposure.
RenderOptions preview_options(RenderOptions options);

/// [m^2/W] The scale at which picture() shows the radiosity: the given or the measured one, exposure included.
double picture_scale(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                     const RenderOptions& options, const ToneMapOptions& tone);

/// A finished picture for the screen: exposure is measured on a small preview, then the picture is rendered with white
/// where the exposure puts it (options.white is not used) and tone mapped.
ScreenImage picture(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                    const RenderOptions& options, const ToneMapOptions& tone);

} // namespace multipath
