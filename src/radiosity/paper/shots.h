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
    Rgb power_per_ray; ///< [W] near power_by_line (plan_shots), as a colour
};

/// [W] Unshot power in excess of the threshold [W/m^2], summed over the patches, mean of the channels.
double power_above(const Scene& scene, const PowerState& state, double threshold);

/// The shots of pass number `pass`, in the order of the patches: every patch with unshot radiosity above the threshold
/// [W/m^2] shoots the excess (S1) (S2). `power_by_line` [W]: wanted power of one ray, mean of the channels, the
/// `PowerByLine` of the paper (Castro, Martinez, Sbert 1998); with 0 there are no shots. A patch whose excess is worth
/// n rays gets n rays on average over all seeds: n is rounded by systematic sampling, from an offset that depends on
/// seed and pass. If n >= 1, the rays carry the excess of the patch; if n < 1, a ray carries power_by_line. One factor
/// per channel then multiplies the power of all rays, so that together they carry the whole excess, which makes a bias
/// that falls with the number of rays. It is at most 2, so very few rays may carry less. If every patch is worth a ray,
/// those of pass 0 are the same for every seed.
std::vector<Shot> plan_shots(const Scene& scene, const PowerState& state, double threshold, double power_by_line,
                             std::uint64_t seed, std::uint64_t pass);

/// The shots of a first pass with a given total number of rays. Empty if `rays` is 0, or if no patch exceeds the
/// threshold.
std::vector<Shot> plan_first_shot(const Scene& scene, const PowerState& state, double threshold, std::uint64_t rays,
                                  std::uint64_t seed);

/// Subtracts the power of the shots from the unshot power of the patches, in proportion to their excess. A patch that
/// got no ray by rounding loses its part like the others: the rays of others carry it. In total no power is created or
/// lost.
void spend(const Scene& scene, double threshold, const std::vector<Shot>& shots, PowerState& state);

/// The rays of all shots, in order; the shots are the recipients.
Allotment rays_of(const std::vector<Shot>& shots);

/// Adds the power of all rays but the first `rays_sent` back to the unshot power of their shooters.
void keep_unsent(const std::vector<Shot>& shots, std::uint64_t rays_sent, PowerState& state);

} // namespace multipath
