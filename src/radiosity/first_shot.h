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

/// Which part of the unshot power is to be shot, and how finely.
struct ShotRule
{
    double threshold = 0.0;     ///< [W/m^2] unshot radiosity that every patch keeps (4)
    double power_by_line = 0.0; ///< [W] of one ray, mean of the channels: `PowerByLine` of the paper
    double offset = 0.5;        ///< [0, 1) where rounding begins; uniform random: no patch is favoured on the average
};

/// [W] What exceeds the threshold, of all patches together, mean of the channels.
double power_above(const Scene& scene, const PowerState& state, double threshold);

/// The rays of one pass over the patches: each with unshot radiosity above the threshold shoots the excess (S1) (S2). A
/// patch that deserves n rays gets n rounded down or up, with expectation n over the offset. If n >= 1 these carry
/// its excess; otherwise the one ray that it gets now and then carries power_by_line. In all, the rays carry the whole
/// excess: where rounding would make it more or less, all are corrected by one factor for each channel, at most 2.
std::vector<Shot> plan_shots(const Scene& scene, const PowerState& state, const ShotRule& rule);

/// The same for a number of rays in all (fewer only when nothing exceeds the threshold).
std::vector<Shot> plan_first_shot(const Scene& scene, const PowerState& state, double threshold, std::uint64_t rays);

/// Takes what the shots carry from the patches, in proportion to their excess, also from those that rounding gave no
/// ray: each has spent it in expectation, and no power is made or lost.
void spend(const Scene& scene, double threshold, const std::vector<Shot>& shots, PowerState& state);

/// Rays of all shots together.
std::uint64_t ray_count(const std::vector<Shot>& shots);

} // namespace multipath
