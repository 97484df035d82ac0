#pragma once

#include "geometry/surface.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// A patch size [scene units] that gives a few thousand patches: the largest round number not above sqrt(A / 2500), or
/// up to 2.5 times as much if it takes that to stay below 4000 patches.
double default_patch_size(const std::vector<Surface>& surfaces);

/// The patch size [scene units] that cuts the surfaces into a number of patches close to `wanted`, never above it
/// unless the surfaces alone are more.
double patch_size_for_count(const std::vector<Surface>& surfaces, std::uint64_t wanted);

} // namespace multipath
