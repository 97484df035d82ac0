#pragma once

#include "scene/scene_file.h"
#include "scene/tessellation.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Identifies what a result was computed from: geometry, reflectances, emittances, subdivision and sides, but not
/// names, comments or the spelling of numbers. FNV-1a over 64-bit values, the same on every machine.
std::uint64_t scene_hash(const SceneFile& file, const std::vector<Tessellation>& tessellations, bool two_sided);

} // namespace multipath
