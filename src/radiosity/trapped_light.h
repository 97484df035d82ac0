#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <optional>

namespace multipath {

/// A patch, if there is one, from which light goes on for ever: in some channel in which it is reflected it meets only
/// patches of reflectance 1 in that channel, and the radiosity has no bound. Decided by following up to 4096 particles
/// from the sources, at least one for each source while there are fewer; a space in which a share of the reflections
/// below 1e-5 absorbs counts as closed.
std::optional<std::uint32_t> patch_of_trapped_light(const Scene& scene);

/// Throws InputError if light is trapped.
void require_absorption(const Scene& scene);

} // namespace multipath
