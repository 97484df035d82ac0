#pragma once

#include "geometry/bounds.h"
#include "geometry/surface.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// The box around all surfaces; empty without any.
Bounds bounds_of(const SurfaceList& surfaces);

/// Around all surfaces, with room for how far beside it a surface may be met: on a plane that it shares with others
/// (see coplanar_distance) and by rounding.
Bounds box_around(const SurfaceList& surfaces);

/// Around each surface, with the same room.
LargeVector<Bounds> boxes_around_each(const SurfaceList& surfaces);

/// The numbers of the surfaces, the largest first; of equal ones the earlier.
std::vector<std::uint32_t> from_large_to_small(const SurfaceList& surfaces);

/// The place of each surface by size, the smallest first; of equal ones the later. `order`: from large to small.
std::vector<std::uint32_t> size_ranks(const std::vector<std::uint32_t>& order);

/// Whether the surfaces are the inside of a room rather than the outside of things: the volume that their fronts bound
/// from outside is negative (divergence theorem). A room without one wall still counts as a room.
bool form_a_room(const SurfaceList& surfaces);

} // namespace multipath
