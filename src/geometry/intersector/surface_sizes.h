#pragma once

#include "geometry/bounds.h"
#include "geometry/surface.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Bounding box of all surfaces; empty if there are none.
Bounds bounds_of(const SurfaceList& surfaces);

/// Bounding box of all surfaces with a margin on each side: 2 * coplanar_distance times the diagonal of the box without
/// margin, and more for coordinates far from the origin. A hit may lie slightly off the surface, by rounding and
/// because coplanar surfaces share one plane. The result is meaningless if there are no surfaces.
Bounds box_around(const SurfaceList& surfaces);

/// Bounding box of each surface, with margins as in box_around(): the diagonal is that of the box of all surfaces.
LargeVector<Bounds> boxes_around_each(const SurfaceList& surfaces);

/// Indices of the surfaces by descending area; surfaces of equal area by ascending index.
std::vector<std::uint32_t> order_by_descending_area(const SurfaceList& surfaces);

/// True if the surfaces are the inside of a room rather than the outside of objects: the volume that they enclose,
/// computed by the divergence theorem with fronts outwards, is negative (below -1e-9 times the diagonal cubed). A room
/// that lacks a wall still counts as a room.
bool is_interior(const SurfaceList& surfaces);

} // namespace multipath
