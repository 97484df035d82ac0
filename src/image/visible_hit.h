#pragma once

#include "geometry/intersector.h"
#include "geometry/line.h"
#include "scene/scene.h"

#include <optional>

namespace multipath {

/// The first side that exists along a ray: the backs of one-sided surfaces are looked through, so that a closed room
/// can be seen from outside.
std::optional<Hit> visible_hit(const Scene& scene, const Line& ray);

} // namespace multipath
