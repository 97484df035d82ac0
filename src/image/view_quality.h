#pragma once

#include "image/camera.h"
#include "scene/scene.h"

namespace multipath {

/// What a coarse grid of rays says about a view.
struct ViewQuality
{
    double score = 0.0;         ///< higher is better, comparable between cameras in one scene
    double escaped_share = 0.0; ///< of the rays
    double back_share = 0.0;    ///< of the rays, that met a surface from behind
};

/// How good a picture of the scene the camera gives. Counts how much and how many different places of the scene are
/// seen from the front, and punishes rays that leave the scene, meet backs, or meet something right before the lens.
/// `rows` rays judge the picture's height.
ViewQuality view_quality(const Scene& scene, const Camera& camera, double aspect, int rows);

} // namespace multipath
