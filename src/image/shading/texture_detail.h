#pragma once

#include "geometry/hit.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

// Pictures show textures at full resolution on light that is known per patch: what is interpolated is the radiosity
// that the patches would have without the detail of their texture, and the texture is put back at each point.

/// [W/m^2] The radiosity of every patch if it reflected what its material reflects on average. The same as `radiosity`
/// in scenes without textures.
std::vector<Rgb> without_texture(const Scene& scene, std::vector<Rgb> radiosity);

/// [W/m^2] At a point, of what was interpolated from without_texture().
Rgb with_texture(const Scene& scene, const Hit& hit, Rgb plain);

} // namespace multipath
