#pragma once

#include "geometry/convex_hull.h"
#include "geometry/surface.h"

#include <vector>

namespace multipath {

/// The convex hull of all surfaces.
ConvexHull hull_of(const std::vector<Surface>& surfaces);

} // namespace multipath
