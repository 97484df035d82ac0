#pragma once

#include "geometry/hit.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

// Pictures show textures at full resolution although light is known per patch only. The radiosity that patches would
// have without the detail of their texture is interpolated, and the texture is applied again at each point.

/// [W/m^2] The radiosity that every patch would have with the mean reflectance of its material in place of its texture.
/// Equal to `radiosity` in scenes without textures.
std::vector<Rgb> without_texture(const Scene& scene, std::vector<Rgb> radiosity);

/// [W/m^2] Applies the texture at a point: radiosity there for `plain`, interpolated from without_texture().
Rgb with_texture(const Scene& scene, const Hit& hit, Rgb plain);

} // namespace multipath
