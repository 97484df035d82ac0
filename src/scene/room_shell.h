#pragma once

#include "scene/scene_file.h"

#include <cstddef>

namespace multipath {

/// Turns the walls of rooms over that look outward, as modellers make them, so that their fronts see the room:
/// connected surfaces that are closed, look outward, and surround emitters of less than a quarter of their area; or
/// that are convex, reach as far as the scene on all sides, and hold all emitters, which light nothing. What only
/// touches them stays as it is. Returns how many surfaces were turned; 0 for all other scenes, and for such as consist
/// of emitters.
std::size_t turn_shells_inward(SceneFile& file);

} // namespace multipath
