#pragma once

#include "radiosity/power_state.h"
#include "sampling/sequence.h"
#include "scene/scene.h"
#include "transport/line_counter.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// One patch sends rays, each with the same power.
struct Shot
{
    std::uint32_t patch;
    std::uint64_t rays;
    Rgb power_per_ray; ///< [W] `PowerByLine` of the paper, with a colour
};

/// Sends the rays of all shots, which take the items from first_item on, one each in order. Every receiver adds what
/// arrives to its incident power and what it reflects to its unshot power (S1). The shooters' unshot power is spent
/// beforehand (see spend in first_shot.h).
void shoot(const Scene& scene, const Sequence& sequence, std::uint64_t first_item, const std::vector<Shot>& shots,
           int threads, PowerState& state, const LineCounter& count_lines);

} // namespace multipath
