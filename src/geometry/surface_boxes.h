#pragma once

#include "geometry/bounds.h"
#include "geometry/surface.h"

#include <vector>

namespace multipath {

/// The box around all surfaces; empty without any.
Bounds bounds_of(const std::vector<Surface>& surfaces);

/// Around all surfaces, with room for how far beside it a surface may be met: on a plane that it shares with others
/// (see coplanar_distance) and by rounding.
Bounds box_around(const std::vector<Surface>& surfaces);

/// Around each surface, with the same room.
std::vector<Bounds> boxes_around_each(const std::vector<Surface>& surfaces);

} // namespace multipath
