#pragma once

#include "geometry/bounds.h"
#include "geometry/vec3.h"
#include "parallel/memory.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Maps every vertex to a representative of all vertices at exactly the same position. Exporters repeat a vertex per
/// face or per object; with these indices, faces that share an edge are found. Linear time.
LargeVector<std::uint32_t> weld(const LargeVector<Vec3>& vertices);

/// Index triple of the point of a grid nearest to `point`; the spacing is 1e-7 of the diagonal of `bounds`. Corners of
/// surfaces are computed from edges and differ by rounding; snapped they become equal.
Vec3 snapped(Vec3 point, const Bounds& bounds);

} // namespace multipath
