#pragma once

#include "scene/scene.h"

#include <vector>

namespace multipath {

/// True for each patch that is invisible in all pictures because coplanar surfaces cover all of it, up to slivers. Of
/// two coincident surfaces the smaller lies on top, as in Intersector::closest_hit. A mesh with both surfaces would
/// flicker (z-fighting).
std::vector<bool> covered_patches(const Scene& scene, int threads);

} // namespace multipath
