#pragma once

#include "scene/scene_file.h"

#include <cstddef>

namespace multipath {

/// Turns over the walls of rooms that were modelled facing outward, so that their fronts face the interior. The walls
/// of such a room are a closed, connected part of the scene that faces outward and either surrounds emitters of less
/// than a quarter of its area, or is convex, extends to all sides of the scene and contains all emitters, which
/// therefore light nothing. Surfaces that only touch it stay. Returns the number of surfaces turned; 0 if the scene has
/// no such room, or if none or all of its surfaces emit.
std::size_t turn_shells_inward(SceneFile& file);

} // namespace multipath
