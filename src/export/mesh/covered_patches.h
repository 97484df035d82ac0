#pragma once

#include "scene/scene.h"

#include <vector>

namespace multipath {

/// True for each patch that is invisible in all pictures because coplanar surfaces cover all of it, up to slivers. As
/// in Intersector::closest_hit, a front lies over a back; of two coincident surfaces that face the same way, the
/// smaller lies on top. A mesh with the covered patches would flicker (z-fighting).
std::vector<bool> covered_patches(const Scene& scene, int threads);

} // namespace multipath
