#pragma once

#include "parallel/run_control.h"
#include "radiosity/paper/power_state.h"
#include "radiosity/paper/shots.h"
#include "sampling/sequence.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Casts the rays of all shots, in order, with one item each from first_item on. The power that arrives at a patch is
/// added to the incident power of the patch, and the reflected part to its unshot power ((S1) in docs/equations.md).
/// The caller subtracts the power from the shooters beforehand, see spend(). The checkpoint saves `state`; the caller
/// must give the same shots when the run is resumed. If the run is stopped, the shooters get back the power of the rays
/// that were not cast. Returns the number of rays of the shots.
std::uint64_t shoot(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                    const std::vector<Shot>& shots, const RunControl& run, PowerState& state);

} // namespace multipath
