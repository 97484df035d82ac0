#pragma once

#include "scene/scene.h"

#include <cstdint>

namespace multipath {

/// For two patches of opposite orientation in one plane: true if their fronts face each other across a gap of no width,
/// like the bottom of a box and the floor below it; false if they are back to back, like the two faces of a thin sheet.
/// A ray from a point that both patches contain decides it. False also where the overlap is too narrow to find such a
/// point.
bool in_contact(const Scene& scene, std::uint32_t a, std::uint32_t b);

} // namespace multipath
