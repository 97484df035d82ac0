#pragma once

#include "geometry/bounds.h"
#include "geometry/vec3.h"
#include "parallel/memory.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Returns for each vertex the index of the first vertex at exactly the same position: one representative for all
/// vertices there. Exporters repeat a vertex per face or per object; with these indices, faces that share an edge are
/// found. Linear time. In a file made to cause hash collisions some vertices keep their own index.
LargeVector<std::uint32_t> weld(const LargeVector<Vec3>& vertices);

/// Index triple of the point of a grid nearest to `point`; the spacing is 1e-7 of the diagonal of `bounds`. Corners of
/// surfaces are computed from edges and differ by rounding; snapped they become equal.
Vec3 snapped(Vec3 point, const Bounds& bounds);

} // namespace multipath
