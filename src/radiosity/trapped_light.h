#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <optional>

namespace multipath {

/// A patch among which light is trapped, if there is one: in some channel the light meets only patches of reflectance
/// 1, and the radiosity is unbounded. Found by following up to 4096 particles from the sources, at least one per source
/// as far as that suffices. A space that absorbs at less than a fraction 1e-5 of the reflections may count as closed.
std::optional<std::uint32_t> patch_of_trapped_light(const Scene& scene);

/// Throws InputError if light is trapped.
void require_absorption(const Scene& scene);

} // namespace multipath
