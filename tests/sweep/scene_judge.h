#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// What is wrong with the light that each method finds in a scene with so many lines, in words; empty if nothing is.
/// `convex`: no surface sees anything but a uniform sky. Each run must end, without an error, with finite radiosities
/// not below the emittances and losses between nothing and all of the light. The mean radiosity of each material and
/// side over several runs must be within four standard errors and 0.2 % of that of particles (the method `local`) on
/// the same patches; whatever is not is compared again with four times as many runs, twice, so that chance fails next
/// to never.
std::vector<std::string> faults(const Scene& scene, std::uint64_t lines, bool convex, std::uint64_t seed);

} // namespace multipath
