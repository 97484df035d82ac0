#pragma once

#include "scene/scene.h"

#include <vector>

namespace multipath {

/// Smooth values at the corners of all patches, as pictures interpolate them (SmoothShading): surface by surface in the
/// order of CornerLattice, the fronts first, then, with two sides, the backs.
std::vector<Rgb> corner_values(const Scene& scene, const std::vector<Rgb>& values_per_patch);

} // namespace multipath
