#pragma once

#include "parallel/run_control.h"
#include "radiosity/paper/shots.h"
#include "sampling/sequence.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace multipath {

/// Parameters of the extended first shot.
struct ExtendedShotOptions
{
    static constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

    /// [W/m^2] Unshot radiosity (emitted or reflected, but not yet sent on) that every patch keeps: that of (4),
    /// threshold_radiosity(), unless the user sets it. With threshold 0 the method is progressive ray refinement (Feda
    /// and Purgathofer 1993, Shirley 1991).
    double threshold = 0.0;
    /// N_l, number of rays to cast, reached approximately: by (3), local_line_count(N, optimal_ratio(...)), unless the
    /// user sets the ratio. If power_by_line is set, the largest number.
    std::uint64_t lines = no_limit;
    std::optional<double> power_by_line; ///< [W] power of one ray (plan_shots), if the user sets it
    int most_steps = 1000;               ///< maximum number of passes over the patches
    std::uint64_t seed = 0;              ///< seed of the random rounding to whole rays
};

/// Statistics of one pass over the patches.
struct ShotPass
{
    std::uint64_t lines = 0; ///< rays of the pass, including those that a stopped run did not cast
    double power = 0.0;      ///< [W] unshot power above the threshold when the pass began, mean of the channels
    PowerBalance balance;    ///< after the pass
};

/// Called before each pass, and again when a pass is resumed, with the index of the item of its first ray, its shots,
/// and the state from which the power of the shots has already been subtracted.
using PassObserver =
    std::function<void(std::uint64_t first_item, const std::vector<Shot>& shots, const PowerState& state)>;

inline void ignore_pass(std::uint64_t, const std::vector<Shot>&, const PowerState&) {}

/// The extended first shot ((S2) in docs/equations.md): in each pass, every patch whose unshot radiosity exceeds the
/// threshold shoots the excess. Ends when no patch exceeds it or none gets a ray by rounding, when the lines are used
/// up, after most_steps passes, or when the run is stopped. The rays take the items of the sequence from first_item on.
/// Returns the passes. `state` is a new PowerState(scene), which the caller must save in the checkpoint as it is
/// between two passes; this function saves the rest.
std::vector<ShotPass> shoot_extended(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                     const ExtendedShotOptions& options, const RunControl& run, PowerState& state,
                                     const PassObserver& observe = ignore_pass);

/// The same with few rays: about `rays` in the first pass, and of the same power in the others. It takes the items that
/// the rays of a run with these options take.
std::vector<ShotPass> shoot_pilot(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                  ExtendedShotOptions options, std::uint64_t rays, int threads, PowerState& state);

/// Reads or writes the passes for a checkpoint.
void visit(Archive& archive, std::vector<ShotPass>& passes);

} // namespace multipath
