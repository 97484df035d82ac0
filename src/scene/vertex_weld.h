#pragma once

#include "geometry/vec3.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// For every vertex one that stands for all vertices at exactly the same position. Exporters repeat a vertex per face
/// or per object; edges shared by faces are found by these numbers. Linear time.
std::vector<std::uint32_t> weld(const std::vector<Vec3>& vertices);

} // namespace multipath
