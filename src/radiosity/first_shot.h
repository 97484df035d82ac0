#pragma once

#include "radiosity/shooting.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// The rays of the first shot (S1): every source patch sends what its radiosity exceeds the threshold [W/m^2] by, in
/// rays of equal power, `rays` in all (fewer only when nothing exceeds the threshold).
std::vector<Shot> plan_first_shot(const Scene& scene, const PowerState& state, double threshold, std::uint64_t rays);

} // namespace multipath
