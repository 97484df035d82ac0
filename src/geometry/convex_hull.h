#pragma once

#include "geometry/vec3.h"

#include <vector>

namespace multipath {

/// Surface area of the convex hull of the points, to about 1e-6 relative. A flat set counts both of its sides, as
/// integral geometry does; fewer than three distinct points give 0.
double convex_hull_area(const std::vector<Vec3>& points);

} // namespace multipath
