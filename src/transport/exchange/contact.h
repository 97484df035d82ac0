#pragma once

#include "scene/scene.h"

#include <cstdint>

namespace multipath {

/// Of two patches in one plane whose sides are turned towards each other: is it across a gap of no width, as between a
/// box and the floor that it stands on, or are they back to back, as on a sheet made of two faces? Decided as for rays,
/// at a point that both patches share; false where the overlap is too narrow to find one.
bool in_contact(const Scene& scene, std::uint32_t one, std::uint32_t other);

} // namespace multipath
