#pragma once

#include "geometry/hit.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

// Pictures show textures at full resolution although light is known per patch only. The radiosity that patches would
// have without the detail of their texture is interpolated. Then the texture is applied again at each point.

/// [W/m^2] The radiosity that every patch would have if, under the same irradiance, it had the mean reflectance of its
/// material instead of its texture. Where a patch is black in a channel, the irradiance in this channel is unknown and
/// taken to be the mean of the other channels. Equal to `radiosity` in scenes without textures.
std::vector<Rgb> without_texture(const Scene& scene, std::vector<Rgb> radiosity);

/// [W/m^2] Radiosity at a hit with the texture applied. `plain`: the radiosity there without texture, interpolated from
/// without_texture().
Rgb with_texture(const Scene& scene, const Hit& hit, Rgb plain);

} // namespace multipath
