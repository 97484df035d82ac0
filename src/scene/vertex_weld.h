#pragma once

#include "geometry/vec3.h"
#include "parallel/memory.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Maps every vertex to a representative of all vertices at exactly the same position. Exporters repeat a vertex per
/// face or per object; with these indices, faces that share an edge are found. Linear time.
LargeVector<std::uint32_t> weld(const LargeVector<Vec3>& vertices);

} // namespace multipath
