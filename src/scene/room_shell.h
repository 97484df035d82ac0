#pragma once

#include "scene/scene_file.h"

#include <cstddef>

namespace multipath {

/// Turns a room's walls over that look outward, as modellers make them, so that their fronts see the room: the
/// connected surfaces that reach as far as the scene on all sides, if they are closed, look outward, and either all
/// emitters lie within them or they are convex and their own emitters light nothing. What else there is stays as it is.
/// Returns how many surfaces were turned; 0 for all other scenes, and for such as consist of emitters.
std::size_t turn_shell_inward(SceneFile& file);

} // namespace multipath
