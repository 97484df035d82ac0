#pragma once

#include "base/memory.h"
#include "geometry/bounds.h"
#include "geometry/vec3.h"

#include <cstdint>

namespace multipath {

/// Returns for each vertex the index of the first vertex at exactly the same position: one representative for all
/// vertices there. Exporters repeat a vertex per face or per object; with these indices, faces that share an edge are
/// found. Linear time, since the search for each vertex is bounded: in a file made to cause hash collisions some equal
/// vertices are not merged.
LargeVector<std::uint32_t> weld(const LargeVector<Vec3>& vertices);

/// Integer coordinates of the grid point that is nearest to `point`; the spacing of the grid is 1e-7 of the diagonal of
/// `bounds`. Coinciding corners that are computed from different edges differ by rounding; once snapped they are equal,
/// except in the rare case that they lie closest to different grid points.
Vec3 snapped(Vec3 point, const Bounds& bounds);

} // namespace multipath
