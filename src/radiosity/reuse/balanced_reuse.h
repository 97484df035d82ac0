#pragma once

#include "parallel/run_control.h"
#include "radiosity/power_state.h"
#include "radiosity/reuse/gathered_light.h"
#include "sampling/sequence.h"

#include <cstddef>
#include <cstdint>

namespace multipath {

/// Rays of a balanced reuse.
struct BalancedRays
{
    std::uint64_t first_item = 0; ///< of the sequence
    std::uint64_t rays = 0;       ///< at least fewest_balanced_rays
    bool direct = true;           ///< sends the light of the sources; else it has been sent before
    bool indirect = true;         ///< sends what is reflected; else it stays unshot
};

/// With fewer rays than these, a few per patch, nothing is known of most patches.
std::uint64_t fewest_balanced_rays(const Scene& scene);

/// [bytes] that a run with balanced reuse takes in all, at the least.
double least_balanced_bytes(const Scene& scene);

struct BalancedResult
{
    std::uint64_t rays = 0; ///< that were cast
    bool solved = false;    ///< otherwise the run was stopped, and the state holds the light that was not found
    std::vector<Rgb>
        variance; ///< [(W/m^2)^2] per patch: of its radiosity, as its own rays tell it; empty unless solved
};

/// Distributes all unshot power of scenes with any number of patches. Every patch gets as many rays as it is worth:
/// some to the lights (GatheredLight), and some over the hemisphere, which are counted where they arrive. A ray counts
/// for both of its ends (SparseExchange), and the light is solved for (R1). How many, two smaller rounds tell, whose
/// rays count too: what they find says how many rays each patch gets in the next. Where with all counts the run would
/// take more than `memory` [bytes], the last round is cut into parts that are solved one by one and averaged. A run
/// that is stopped after the first round is solved with the rays that it has. A checkpoint must hold the state, too.
/// Throws InputError if the equations have no solution.
BalancedResult reuse_balanced(const Scene& scene, const SceneLights& lights, const Sequence& sequence,
                              const BalancedRays& rays, double memory, const RunControl& run, PowerState& state);

} // namespace multipath
