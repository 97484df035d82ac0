#pragma once

#include "geometry/bounds.h"
#include "geometry/vec3.h"
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
    Bounds box;               ///< region that a picture should show: the whole scene, unless set to a part of it
    std::vector<bool> is_lit; ///< per patch
    double weight = 0.0;      ///< of all surfaces, in the score
};

/// Measures of a view by a coarse grid of rays.
struct ViewQuality
{
    double score = 0.0;         ///< higher is better, comparable between cameras in one scene
    double escaped_share = 0.0; ///< of the rays
    double back_share = 0.0;    ///< of the rays, that met a surface from behind
    double dark_share = 0.0;    ///< of the rays, that ended on a patch without light

    /// True if most of the surfaces met are lit.
    bool is_lit() const { return escaped_share < 1.0 && dark_share <= 0.3 * (1.0 - escaped_share); }
};

/// Quality of the camera's picture of the scene. Rewards how much of the scene and how many different parts of it are
/// seen from the front and in light; punishes rays that leave the scene, meet backs, end in the dark, or meet something
/// close to the lens. `rows`: rays over the picture's height.
ViewQuality view_quality(const LitScene& sight, const Camera& camera, double aspect, int rows);

/// A camera that shows most of the scene well: from inside a closed room, from behind a wall (looked through, as the
/// backs of one-sided surfaces are) of one too small to step back in, or from outside through an open side. `aspect` is
/// the picture's width / height; `up` must be finite and not zero (SettingsError). `radiosity` [W/m^2] per patch shows
/// where the light is; without it all surfaces count as lit. The same scene and light always give the same camera.
Camera automatic_camera(const Scene& scene, double aspect, Vec3 up = {0.0, 1.0, 0.0},
                        const std::vector<Rgb>& radiosity = {});

} // namespace multipath
