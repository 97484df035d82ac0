#pragma once

#include "geometry/bounds.h"
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
    std::vector<Rgb> radiosity;   ///< [W/m^2] per patch; empty if unknown
    Bounds box;                   ///< region that a picture should show; initially the whole scene without its sky
    std::vector<bool> is_lit;     ///< per patch
    double usual_radiosity = 0.0; ///< [W/m^2] mean over the area without the sky; 0 if unknown
    double weight = 0.0;          ///< sum over all surfaces but the sky of sqrt(area); normalises part of the score
};

/// True if light comes from outside: from a sky or a sun.
bool has_daylight(const Scene& scene);

/// Quality of a view, measured with a coarse grid of rays. The shares are fractions of the rays.
struct ViewQuality
{
    static constexpr double most_in_the_way = 1.0 / 3.0; ///< [1] largest in_the_way_share of a good view

    double score = 0.0;         ///< higher is better; comparable between cameras in one scene
    double escaped_share = 0.0; ///< [1] rays that leave the scene; 0 if the scene has a sky
    double back_share = 0.0;    ///< [1] rays that first meet the back of a surface other than the sky
    double dark_share = 0.0;    ///< [1] rays that end on an unlit patch
    /// [1] Rays that end on a patch, not of a lamp, that automatic exposure would show white or almost black.
    double unexposed_share = 0.0;
    double in_the_way_share = 0.0; ///< [1] rays that end at a distance of less than a tenth of the diagonal

    /// True if some rays stay in the scene, of which at most 30 % end on unlit patches and 30 % on unexposed ones, and
    /// if nothing in the way fills more than a third of the picture.
    bool is_good() const
    {
        const double most = 0.3 * (1.0 - escaped_share);
        return escaped_share < 1.0 && dark_share <= most && unexposed_share <= most &&
               in_the_way_share <= most_in_the_way;
    }
};

/// Quality of a camera's picture of the scene, from a grid of rays with `rows` rays over the height of the picture. The
/// score rewards the amount and the variety of surfaces that are seen lit and from the front, among them floor, ceiling
/// and lamps, and in daylight their brightness. It penalises rays that leave the scene, meet backs, end on unlit or
/// badly exposed patches, or hit a lit front close to the lens, a picture that is hidden by something in the way, and
/// one that is nearly all sky. `aspect`: width / height of the picture. Throws SettingsError for an invalid camera
/// (PixelRays).
ViewQuality view_quality(const LitScene& lit_scene, const Camera& camera, double aspect, int rows);

} // namespace multipath
