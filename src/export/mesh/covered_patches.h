#pragma once

#include "scene/scene.h"

#include <vector>

namespace multipath {

/// True for each patch that no picture shows any part of, because other surfaces of the same plane lie over all of it:
/// by the rule of Intersector::closest_hit, the smaller surface over the larger. Meshes would show both at random.
std::vector<bool> covered_patches(const Scene& scene, int threads);

} // namespace multipath
