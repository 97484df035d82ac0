#pragma once

#include "geometry/bounds.h"
#include "image/camera.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// The part of a scene that is worth seeing: where the light is.
struct LitScene
{
    /// `radiosity` [W/m^2] per patch; all patches count as lit if it is empty or zero.
    explicit LitScene(const Scene& scene, const std::vector<Rgb>& radiosity = {});

    const Scene& scene;
    Bounds box;               ///< what a picture should show: of the scene, unless it is set to a part
    std::vector<bool> is_lit; ///< per patch
    double weight = 0.0;      ///< of all surfaces, in the score
};

/// What a coarse grid of rays says about a view.
struct ViewQuality
{
    double score = 0.0;         ///< higher is better, comparable between cameras in one scene
    double escaped_share = 0.0; ///< of the rays
    double back_share = 0.0;    ///< of the rays, that met a surface from behind
    double dark_share = 0.0;    ///< of the rays, that ended on a patch without light

    /// True if most of what is met shows light.
    bool is_lit() const { return escaped_share < 1.0 && dark_share <= 0.3 * (1.0 - escaped_share); }
};

/// How good a picture of the scene the camera gives. Counts how much and how many different places of the scene are
/// seen from the front and in light, and punishes rays that leave the scene, meet backs, end in the dark, or meet
/// something right before the lens. `rows` rays judge the picture's height.
ViewQuality view_quality(const LitScene& sight, const Camera& camera, double aspect, int rows);

} // namespace multipath
