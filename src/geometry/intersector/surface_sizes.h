#pragma once

#include "geometry/bounds.h"
#include "geometry/surface.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Bounding box of all surfaces; empty if there are none.
Bounds bounds_of(const SurfaceList& surfaces);

/// Bounding box of all surfaces with a margin, because hits may lie slightly off a surface: on a plane that it shares
/// with others (see coplanar_distance) and by rounding.
Bounds box_around(const SurfaceList& surfaces);

/// Bounding box of each surface, with the same margin.
LargeVector<Bounds> boxes_around_each(const SurfaceList& surfaces);

/// Indices of the surfaces by descending area; equal ones in ascending order.
std::vector<std::uint32_t> order_by_descending_area(const SurfaceList& surfaces);

/// Rank of each surface by area, 0 for the smallest; of equal ones the later ranks lower. `order`: the result of
/// order_by_descending_area.
std::vector<std::uint32_t> size_ranks(const std::vector<std::uint32_t>& order);

/// True if the surfaces are the inside of a room rather than the outside of objects: the volume that they enclose with
/// their fronts outwards, by the divergence theorem, is negative. A room without one wall still counts as a room.
bool is_interior(const SurfaceList& surfaces);

} // namespace multipath
