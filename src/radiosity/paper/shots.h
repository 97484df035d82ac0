#pragma once

#include "radiosity/paper/power_state.h"
#include "sampling/allotment.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Rays of equal power from one patch.
struct Shot
{
    std::uint32_t patch;
    std::uint64_t rays;
    Rgb power_per_ray; ///< [W] `PowerByLine` of the paper (Castro, Martinez, Sbert 1998), as a colour
};

/// [W] Unshot power in excess of the threshold [W/m^2], summed over the patches, mean of the channels.
double power_above(const Scene& scene, const PowerState& state, double threshold);

/// The shots of pass number `pass`, in the order of the patches: every patch with unshot radiosity above the threshold
/// [W/m^2] shoots the excess (S1) (S2). `power_by_line` [W]: wanted power of one ray, mean of the channels, the
/// `PowerByLine` of the paper. A patch whose excess is worth n rays of power_by_line gets n rays, rounded down or up
/// systematically (whole_part) from an offset, so that the mean over all offsets is n. If n >= 1, these rays carry the
/// excess of the patch. If n < 1, the patch gets a single ray for a fraction n of the offsets, and this ray carries
/// power_by_line. One factor per channel then multiplies the power of all rays, so that together they carry the whole
/// excess; it is at most 2, so very few rays may carry less. The offset is random, by seed and pass: with a fixed one,
/// the same sources would never get a ray. But it is 0.5 in pass 0 if the excess of every patch is worth a ray, so that
/// the rays of a first shot are the same for every seed.
std::vector<Shot> plan_shots(const Scene& scene, const PowerState& state, double threshold, double power_by_line,
                             std::uint64_t seed, std::uint64_t pass);

/// The shots of a first pass with a given total number of rays. Empty if `rays` is 0, or if no patch exceeds the
/// threshold.
std::vector<Shot> plan_first_shot(const Scene& scene, const PowerState& state, double threshold, std::uint64_t rays,
                                  std::uint64_t seed);

/// Subtracts the power of the shots from the unshot power of the patches, in proportion to their excess. A patch that
/// got no ray by rounding loses its part like the others: it has sent this part in expectation. In total no power is
/// created or lost.
void spend(const Scene& scene, double threshold, const std::vector<Shot>& shots, PowerState& state);

/// The rays of all shots, in order; the shots are the recipients.
Allotment rays_of(const std::vector<Shot>& shots);

/// Adds the power of all rays but the first `rays_sent` back to the unshot power of their shooters.
void keep_unsent(const std::vector<Shot>& shots, std::uint64_t rays_sent, PowerState& state);

} // namespace multipath
