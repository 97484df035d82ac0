#pragma once

#include "geometry/hit.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// [W/m^2] The radiosity that every patch would have if, under the same irradiance, it had the mean reflectance of its
/// material instead of its texture. Where a patch is black in a channel, the irradiance in this channel is unknown and
/// taken to be the mean of the other channels. Equal to `radiosity` in scenes without textures.
std::vector<Rgb> without_texture(const Scene& scene, std::vector<Rgb> radiosity);

/// Interpolates one value per patch to a piecewise continuous function on the surfaces of a scene. Patches share a
/// value at a common corner if they have the same material, lie in one smoothing group (smoothing_groups.h), and no
/// occluder separates them. Parts of patches that furniture covers are ignored. Sources are interpolated like other
/// surfaces. A linear ramp is reproduced.
class SmoothShading
{
public:
    /// `values`: one per patch. The scene must outlive this object. `shown`: per surface, nonzero if at() or
    /// at_corners() will be called for it; empty means all surfaces. Few shown surfaces save time.
    SmoothShading(const Scene& scene, const std::vector<Rgb>& values, int threads, const std::vector<char>& shown = {});

    /// The interpolated value at a hit on a side that has patches.
    Rgb at(const Hit& hit) const;

    /// The values at the corners of a patch, in the order of Scene::corners(). For a triangle the fourth value is 0.
    std::array<Rgb, 4> at_corners(std::uint32_t patch) const;

private:
    const Scene& scene_;
    std::vector<Rgb> corners_; ///< CornerLattice::per_cell slots for each patch
};

/// An indicator of the error of SmoothShading per patch: the open share of the patch (VisiblePatches) times the sum of
/// two terms. The first is the mean square, over corners and channels, of the difference between the corner values and
/// the linear function of the patch. The second is 1/40 of the mean squared second derivative at the patch, which
/// patch_slopes() returns in its parameter `bends`.
std::vector<double> interpolation_errors(const Scene& scene, const std::vector<Rgb>& values, int threads);

/// The radiosity as smooth pictures show it, with details that patches cannot hold, since light is known per patch
/// only. Textures have their full resolution: the radiosity that patches would have without the detail of their texture
/// is interpolated (SmoothShading), and the texture is applied again at each point. Shadows in sunlight have sharp
/// edges: where patches of a plane are partly lit by the sun, and beside them, a ray to the sun is sent from each
/// point, and only the other light is interpolated. On facets of a curved surface sunlight is interpolated too.
class ShownRadiosity
{
public:
    /// `radiosity` [W/m^2] per patch, reflected sunlight included. `shown`: as for SmoothShading. The scene must
    /// outlive this object.
    ShownRadiosity(const Scene& scene, const std::vector<Rgb>& radiosity, int threads,
                   const std::vector<char>& shown = {});

    /// [W/m^2] at a hit on a side that has patches.
    Rgb at(const Hit& hit) const;

private:
    Rgb sunlight(const Hit& hit) const;

    const Scene& scene_;
    SmoothShading light_;                   ///< without sunlight
    std::optional<SmoothShading> sunlight_; ///< red: share of the sun's irradiance; absent without a sun
    std::vector<char> has_edge_;            ///< per patch: nonzero if sunlight is computed at each point
};

} // namespace multipath
