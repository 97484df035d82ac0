#pragma once

#include "geometry/intersector/intersector.h"
#include "scene/scene_file.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// The surfaces that look away from the light and should be turned over, in ascending order:
/// (a) closed, connected parts whose backs receive light while their fronts receive none: rooms that face outward, away
///     from the lamps in them, or solids that face inward. A part around lamps of more than a quarter of its area is
///     the housing of a lamp and stays as it is;
/// (b) if no light arrives anywhere: the closed part that faces outward, reaches all sides of the scene's bounding box
///     and has all the emitters among its own surfaces, such as a room with a bright ceiling;
/// (c) if light arrives at the back of another part and at no front of the scene: all surfaces that do not emit,
/// without
///     those of closed parts.
/// Light comes from lamps, sky and sun, directly or reflected by fronts; it is followed along random paths, at most
/// 16,384 from the lamps and as many from outside, which gives the same result on every machine. Two surfaces are
/// connected if they, and no third surface, have an edge in common, in opposite directions, so objects that only touch
/// a room stay as they are. In a two-sided scene backs reflect light, too, and only (b) applies. Nothing is turned if
/// all of the scene's surfaces emit. `intersector` is that of file.surfaces, with the sky.
std::vector<std::uint32_t> surfaces_to_turn(const SceneFile& file, const Intersector& intersector, bool two_sided);

} // namespace multipath
