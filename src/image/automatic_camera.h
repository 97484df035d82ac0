#pragma once

#include "geometry/bounds.h"
#include "geometry/vec3.h"
#include "image/camera.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// A scene and its lit patches. A good picture shows lit patches.
struct LitScene
{
    /// `radiosity`: [W/m^2] per patch. If the list is empty, or positive for no patch outside the sky, all patches
    /// count as lit. The scene must outlive this object.
    explicit LitScene(const Scene& scene, const std::vector<Rgb>& radiosity = {});

    const Scene& scene;
    Bounds box;               ///< region that a picture should show; initially the whole scene without its sky
    std::vector<bool> is_lit; ///< per patch
    double weight = 0.0;      ///< sum over all surfaces but the sky of sqrt(area); normalises part of the score
};

/// Quality of a view, measured with a coarse grid of rays. The shares are fractions of the rays.
struct ViewQuality
{
    double score = 0.0;         ///< higher is better; comparable between cameras in one scene
    double escaped_share = 0.0; ///< [1] rays that leave the scene; 0 if the scene has a sky
    double back_share = 0.0;    ///< [1] rays that first meet the back of a surface other than the sky
    double dark_share = 0.0;    ///< [1] rays that end on an unlit patch

    /// True if at most 30 % of the rays that stay in the scene end on unlit patches, and at least one ray stays.
    bool is_lit() const { return escaped_share < 1.0 && dark_share <= 0.3 * (1.0 - escaped_share); }
};

/// Quality of a camera's picture of the scene, from a grid of rays with `rows` rays over the height of the picture. The
/// score rewards the amount and the variety of surfaces that are seen lit and from the front, among them floor, ceiling
/// and lamps. It penalises rays that leave the scene, meet backs, end on unlit patches, or hit a lit front close to the
/// lens. `aspect`: width / height of the picture. Throws SettingsError for an invalid camera (PixelRays).
ViewQuality view_quality(const LitScene& lit_scene, const Camera& camera, double aspect, int rows);

/// Finds a camera that shows most of the scene well. The camera stands inside a closed room or outside an open one. If
/// a closed room is small, the camera stands outside a wall, whose back is transparent (VisibleHits). `aspect`: width /
/// height of the picture. `radiosity`: [W/m^2] per patch, which determines the lit surfaces; without it all count as
/// lit. Deterministic. Throws SettingsError if `up` is zero or not finite.
Camera automatic_camera(const Scene& scene, double aspect, Vec3 up = {0.0, 1.0, 0.0},
                        const std::vector<Rgb>& radiosity = {});

} // namespace multipath
