#pragma once

#include "parallel/run_control.h"
#include "radiosity/power_state.h"
#include "sampling/sequence.h"
#include "scene/scene.h"

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
/// beforehand (see spend in first_shot.h). If the run is stopped, the power of the other rays stays unshot. A
/// checkpoint must hold the shots and the state besides what this function makes it hold.
void shoot(const Scene& scene, const Sequence& sequence, std::uint64_t first_item, const std::vector<Shot>& shots,
           const RunControl& run, PowerState& state);

/// Gives back to the shooters the power of all rays but the first `rays_sent`: it stays unshot.
void keep_unsent(const std::vector<Shot>& shots, std::uint64_t rays_sent, PowerState& state);

/// For a checkpoint.
void visit(Archive& archive, const Scene& scene, std::vector<Shot>& shots);

} // namespace multipath
