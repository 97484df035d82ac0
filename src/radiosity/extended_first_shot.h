#pragma once

#include "radiosity/first_shot.h"
#include "sampling/sequence.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace multipath {

/// Parameters of the extended first shot.
struct ExtendedShotOptions
{
    double threshold = 0.0;  ///< [W/m^2] that every patch keeps unshot; 0: progressive ray refinement [FP93, Shi91]
    std::uint64_t lines = 0; ///< N_l, number of rays to cast; ignored if power_by_line is set
    std::optional<double> power_by_line; ///< [W] power of one ray, set by the user as in the paper
    int most_steps = 1000;               ///< maximum number of passes over the patches
    std::uint64_t seed = 0;              ///< of the random rounding to whole rays
};

/// Statistics of one pass over the patches.
struct ShotPass
{
    std::uint64_t lines = 0;
    double power = 0.0;   ///< [W] shot in this pass, mean of the channels
    PowerBalance balance; ///< after the pass
};

/// Called before each pass with the item of its first ray, its shots, and the state from which their power has already
/// been subtracted.
using PassObserver =
    std::function<void(std::uint64_t first_item, const std::vector<Shot>& shots, const PowerState& state)>;

/// The extended first shot (S2): in each pass, every patch whose unshot radiosity exceeds the threshold shoots the
/// excess. Ends when a pass has no ray left to shoot, or after most_steps passes. The rays take the items from
/// first_item on. The caller must save `state` in the checkpoint; this function saves the rest.
std::vector<ShotPass> shoot_extended(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                     const ExtendedShotOptions& options, const RunControl& run, PowerState& state,
                                     const PassObserver& observe = {});

/// Reads or writes the passes for a checkpoint.
void visit(Archive& archive, std::vector<ShotPass>& passes);

} // namespace multipath
