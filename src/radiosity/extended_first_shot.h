#pragma once

#include "radiosity/first_shot.h"
#include "sampling/sequence.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace multipath {

/// How the extended first shot is done.
struct ExtendedShotOptions
{
    double threshold = 0.0;  ///< [W/m^2] kept unshot by every patch; 0: progressive ray refinement [FP93, Shi91]
    std::uint64_t lines = 0; ///< N_l to use, if power_by_line is not given
    std::optional<double> power_by_line; ///< [W] fixed by the user, as in the paper
    int most_steps = 1000;               ///< passes over the patches
    std::uint64_t seed = 0;              ///< of the rounding
};

/// One pass over the patches.
struct ShotPass
{
    std::uint64_t lines = 0;
    double power = 0.0;   ///< [W] shot, mean of the channels
    PowerBalance balance; ///< after the pass
};

/// Told before each pass what it is about to shoot: the item of the first ray, the shots, and the state in which what
/// they carry is already spent.
using PassObserver =
    std::function<void(std::uint64_t first_item, const std::vector<Shot>& shots, const PowerState& state)>;

/// The extended first shot (S2): every patch whose unshot radiosity exceeds the threshold shoots the excess, pass by
/// pass, until a pass has no ray left to shoot or the steps are used up. Takes the items from first_item on. A
/// checkpoint must hold the state besides what this function makes it hold.
std::vector<ShotPass> shoot_extended(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                     const ExtendedShotOptions& options, const RunControl& run, PowerState& state,
                                     const PassObserver& observe = {});

/// For a checkpoint.
void visit(Archive& archive, std::vector<ShotPass>& passes);

} // namespace multipath
