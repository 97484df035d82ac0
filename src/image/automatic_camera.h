#pragma once

#include "geometry/bounds.h"
#include "geometry/vec3.h"
#include "image/camera.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// A scene with its lit patches, which a good picture shows.
struct LitScene
{
    /// `radiosity` [W/m^2] per patch. If it is empty or zero, all patches count as lit.
    explicit LitScene(const Scene& scene, const std::vector<Rgb>& radiosity = {});

    const Scene& scene;
    Bounds box;               ///< region that a picture should show; the whole scene without its sky by default
    std::vector<bool> is_lit; ///< per patch
    double weight = 0.0;      ///< sum of the weights of all surfaces but the sky; normalises part of the score
};

/// Quality of a view, measured with a coarse grid of rays.
struct ViewQuality
{
    double score = 0.0;         ///< higher is better; comparable between cameras in one scene
    double escaped_share = 0.0; ///< [1] of the rays: they leave the scene
    double back_share = 0.0;    ///< [1] of the rays: the first surface met shows its back
    double dark_share = 0.0;    ///< [1] of the rays: they end on an unlit patch

    /// True if some ray stays in the scene and at most 30 % of those that do end on unlit patches.
    bool is_lit() const { return escaped_share < 1.0 && dark_share <= 0.3 * (1.0 - escaped_share); }
};

/// Quality of a camera's picture of the scene, from a grid with `rows` rays over its height. The score rewards the
/// amount and the variety of surfaces that are seen lit and from the front. It penalises rays that leave the scene,
/// meet backs, end on unlit patches, or hit something close to the lens. `aspect`: width / height of the picture.
ViewQuality view_quality(const LitScene& lit_scene, const Camera& camera, double aspect, int rows);

/// Finds a camera that shows most of the scene well. It stands inside a closed room, outside an open one, or, if the
/// room is small, outside a wall whose back is transparent (VisibleHits). `aspect`: width / height of the picture.
/// `radiosity` [W/m^2] per patch marks the lit surfaces; without it all count as lit. Deterministic. Throws
/// SettingsError if `up` is zero or not finite.
Camera automatic_camera(const Scene& scene, double aspect, Vec3 up = {0.0, 1.0, 0.0},
                        const std::vector<Rgb>& radiosity = {});

} // namespace multipath
