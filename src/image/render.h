#pragma once

#include "image/camera.h"
#include "image/image.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <limits>
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

/// What the camera sees of a scene with the given radiosity [W/m^2] per patch; black where it meets nothing. Sides that
/// do not exist are looked through. Gathering takes `radiosity` for a solution, of which it replaces the last
/// reflection. The same bytes for any number of threads. Throws SettingsError for an impossible camera or picture size.
Image render(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera, const RenderOptions& options);

} // namespace multipath
