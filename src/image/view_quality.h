#pragma once

#include "image/camera.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// A scene and its light. A good picture shows lit patches.
struct LitScene
{
    /// `radiosity`: [W/m^2] per patch. If the list is empty, all patches count as lit. The scene and the list must
    /// outlive this object.
    LitScene(const Scene& scene, const std::vector<Rgb>& radiosity, double size);

    /// True unless the patch belongs to the sky or has hardly any light compared with the usual radiosity.
    bool is_lit(std::uint32_t patch) const;

    const Scene& scene;
    const std::vector<Rgb>& radiosity; ///< [W/m^2] per patch; empty if unknown
    double size;                       ///< [scene units] diagonal of what a picture should show
    double usual_radiosity = 0.0;      ///< [W/m^2] mean of the reflected part, without the sky; 0 if unknown
    double weight = 0.0; ///< sum over all surfaces but the sky of sqrt(area); normalises part of the score
};

/// True if light comes from outside: from a sky or a sun.
bool has_daylight(const Scene& scene);

/// Quality of a view, measured with a coarse grid of rays. The shares are fractions of the rays.
struct ViewQuality
{
    double score = 0.0;         ///< higher is better; comparable between cameras in one scene
    double escaped_share = 0.0; ///< [1] rays that leave the scene or meet the sky
    double back_share = 0.0;    ///< [1] rays that first meet the back of a surface other than the sky
    double dark_share = 0.0;    ///< [1] rays that end on an unlit patch
};

/// Quality of a camera's picture of the scene, from a grid of rays with `rows` rays over the height of the picture. The
/// score rewards the variety of lit surfaces, materials and places that are seen from the front, and in daylight their
/// brightness. It penalises rays that leave the scene, meet backs, end on unlit patches, or hit something close to the
/// lens. `aspect`: width / height of the picture. Throws SettingsError for an invalid camera (PixelRays).
ViewQuality view_quality(const LitScene& lit_scene, const Camera& camera, double aspect, int rows);

} // namespace multipath
