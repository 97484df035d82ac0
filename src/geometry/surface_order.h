#pragma once

#include "geometry/surface.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// The numbers of the surfaces, the largest first; of equal ones the earlier.
std::vector<std::uint32_t> from_large_to_small(const std::vector<Surface>& surfaces);

/// The place of each surface by size, the smallest first; of equal ones the later. `order`: from large to small.
std::vector<std::uint32_t> size_ranks(const std::vector<std::uint32_t>& order);

/// Whether the surfaces are the inside of a room rather than the outside of things: the volume that their fronts bound
/// from outside is negative (divergence theorem). A room without one wall still counts as a room.
bool form_a_room(const std::vector<Surface>& surfaces);

} // namespace multipath
