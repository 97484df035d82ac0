#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <optional>

namespace multipath {

/// A patch in a space in which light is trapped, or std::nullopt if there is no such space. Light is trapped if it
/// meets only patches of reflectance 1 in some channel, so that the radiosity is unbounded. Found by following 4096
/// particles, spread evenly over the patches of the sources, for up to 65,536 reflections: of more than 4096 such
/// patches some send no particle. A space that loses light in less than a fraction 1e-5 of the reflections may count as
/// closed.
std::optional<std::uint32_t> patch_of_trapped_light(const Scene& scene);

/// Throws InputError if light is trapped (patch_of_trapped_light).
void require_absorption(const Scene& scene);

} // namespace multipath
