#pragma once

#include "parallel/run_control.h"
#include "radiosity/power_state.h"
#include "sampling/sequence.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Rays of equal power from one patch.
struct Shot
{
    std::uint32_t patch;
    std::uint64_t rays;
    Rgb power_per_ray; ///< [W] `PowerByLine` of the paper, as a colour
};

/// Casts the rays of all shots, in order, with one item each from first_item on. Every receiver adds the arriving power
/// to its incident power, and the reflected part to its unshot power (S1). The caller subtracts the power from the
/// shooters beforehand, see spend(), and saves `shots` and `state` in the checkpoint; this function saves the rest. If
/// the run is stopped, the power of the rays that were not cast stays unshot.
void shoot(const Scene& scene, const Sequence& sequence, std::uint64_t first_item, const std::vector<Shot>& shots,
           const RunControl& run, PowerState& state);

/// Returns to the shooters the power of all rays but the first `rays_sent`: it stays unshot.
void keep_unsent(const std::vector<Shot>& shots, std::uint64_t rays_sent, PowerState& state);

/// Reads or writes the shots for a checkpoint. Throws ArchiveError for a patch that does not exist.
void visit(Archive& archive, const Scene& scene, std::vector<Shot>& shots);

/// Which part of the unshot power is shot, and by how many rays.
struct ShotRule
{
    double threshold = 0.0;     ///< [W/m^2] unshot radiosity that every patch keeps (4)
    double power_by_line = 0.0; ///< [W] power of one ray, mean of the channels: `PowerByLine` of the paper
    double offset = 0.5; ///< start of the systematic rounding, in [0, 1); if uniformly random, no patch is favoured
};

/// [W] Unshot power above the threshold, summed over the patches, mean of the channels.
double power_above(const Scene& scene, const PowerState& state, double threshold);

/// The shots of one pass: every patch with unshot radiosity above the threshold shoots the excess (S1) (S2). A patch
/// that deserves n rays gets n rounded down or up, n on the average over the offset. If n >= 1, these rays carry its
/// excess; otherwise the single ray that it sometimes gets carries power_by_line. Together the rays carry the whole
/// excess: one factor per channel, at most 2, corrects the error of the rounding.
std::vector<Shot> plan_shots(const Scene& scene, const PowerState& state, const ShotRule& rule);

/// The same for a given total number of rays (none if no patch exceeds the threshold).
std::vector<Shot> plan_first_shot(const Scene& scene, const PowerState& state, double threshold, std::uint64_t rays);

/// Subtracts the power of the shots from the patches, in proportion to their excess. Patches that got no ray by
/// rounding lose their part, too: they have sent it in expectation, and no power is created or lost.
void spend(const Scene& scene, double threshold, const std::vector<Shot>& shots, PowerState& state);

/// Total number of rays of all shots.
std::uint64_t ray_count(const std::vector<Shot>& shots);

} // namespace multipath
