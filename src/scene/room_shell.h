#pragma once

#include "scene/scene_file.h"

#include <cstddef>

namespace multipath {

/// Turns over the shells (walls, floor and ceiling) of rooms that were modelled inside out, and returns the number of
/// surfaces turned. A closed, connected part of the scene whose fronts face outward is taken for such a shell if either
/// (a) emitters of other parts lie inside it, with a total area of less than a quarter of its own; or
/// (b) all emitters are surfaces of this part, so that they shine outward and light nothing, and the part is convex,
///     has at most 4096 surfaces and reaches all sides of the scene's bounding box.
/// Both conditions are judged by a sample of at most 16 emitters, fewer in scenes of more than 62,500 surfaces. Two
/// surfaces are connected if they, and no third surface, have an edge in common, in opposite directions; surfaces that
/// only touch a shell are not turned. Nothing is turned if none or all of the scene's surfaces emit.
std::size_t turn_shells_inward(SceneFile& file);

} // namespace multipath
