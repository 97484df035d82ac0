#pragma once

#include "scene/rgb.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// [W/m^2] Radiosity of every patch if light were reflected only once: what the patch emits, and what it reflects of
/// the light that comes straight from the sources. Found by gathering, for any method, without chance: always the same.
std::vector<Rgb> direct_radiosity(const Scene& scene, int threads);

} // namespace multipath
