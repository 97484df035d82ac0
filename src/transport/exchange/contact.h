#pragma once

#include "scene/scene.h"

#include <cstdint>

namespace multipath {

/// For two patches of opposite orientation in one plane: true if their fronts face each other across a gap of no width,
/// like the bottom of a box and the floor below it; false if they are back to back, like the two faces of a thin sheet.
/// To decide, a ray leaves the smaller patch at a point that both contain. Returns false if the patches do not overlap,
/// or overlap too narrowly to find such a point.
bool in_contact(const Scene& scene, std::uint32_t a, std::uint32_t b);

} // namespace multipath
