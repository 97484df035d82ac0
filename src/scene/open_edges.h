#pragma once

#include "geometry/surface.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Surfaces with an edge that no other surface runs along in the opposite direction from corner to corner: where a
/// closed scene would leak. An edge that meets several shorter ones counts as open too.
std::vector<std::uint32_t> surfaces_with_open_edges(const std::vector<Surface>& surfaces);

} // namespace multipath
