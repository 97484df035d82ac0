#pragma once

#include "scene/scene_file.h"

#include <cstddef>

namespace multipath {

/// Turns over the shells (walls, floor and ceiling) of rooms that were modelled inside out, and returns the number of
/// surfaces turned. A shell is a closed, connected part of the scene whose fronts face outward, and either
/// (a) other emitters lie inside the shell, and their total area is less than a quarter of the shell's; or
/// (b) all emitters belong to the shell, so that they shine outward and light nothing, and the shell is convex, has at
///     most 4096 surfaces and reaches all sides of the scene's bounding box.
/// Only a sample of at most 16 emitters is tested for this. Surfaces that touch a shell without continuing it (they
/// share no edge with it, or are a third surface at an edge) are not turned. Nothing is turned if none or all of the
/// scene's surfaces emit.
std::size_t turn_shells_inward(SceneFile& file);

} // namespace multipath
