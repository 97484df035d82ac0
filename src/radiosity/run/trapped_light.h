#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <optional>

namespace multipath {

/// A patch in a space in which light is trapped, or std::nullopt if there is no such space. Light is trapped if it
/// meets only patches of reflectance 1 in some channel, so that the radiosity is unbounded. The function follows 4096
/// particles from the patches that emit light or reflect sunlight; light is trapped if, after 65,536 reflections, a
/// particle has lost nothing in some channel. A trap may be missed, since with more than 4096 such patches some send no
/// particle, and since of the surviving particles every other one goes on after 64, 128, 256 ... reflections. A space
/// in which a reflection loses light with a probability below 1e-4 may be taken for a trap.
std::optional<std::uint32_t> patch_of_trapped_light(const Scene& scene);

/// Throws InputError if light is trapped (patch_of_trapped_light).
void require_absorption(const Scene& scene);

} // namespace multipath
