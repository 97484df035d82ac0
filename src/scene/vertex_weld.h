#pragma once

#include "geometry/vec3.h"
#include "parallel/memory.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// For every vertex one that stands for all vertices at exactly the same position. Exporters repeat a vertex per face
/// or per object; edges shared by faces are found by these numbers. Linear time.
LargeVector<std::uint32_t> weld(const LargeVector<Vec3>& vertices);

} // namespace multipath
