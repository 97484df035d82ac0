#pragma once

#include "parallel/run_control.h"
#include "radiosity/power_state.h"
#include "radiosity/reuse/gathered_light.h"
#include "sampling/sequence.h"

#include <cstddef>
#include <cstdint>

namespace multipath {

/// Parameters of balanced reuse.
struct BalancedRays
{
    std::uint64_t first_item = 0; ///< of the sequence
    std::uint64_t rays = 0;       ///< at least min_balanced_rays
    bool direct = true;           ///< distributes the light of the sources; if false, this was done before
    bool indirect = true;         ///< distributes the reflected light; if false, it stays unshot
};

/// Minimum number of rays. With fewer, most patches would have no estimate.
std::uint64_t min_balanced_rays(const Scene& scene);

/// [bytes] Lower bound of the total memory of a run with balanced reuse.
double min_balanced_bytes(const Scene& scene);

struct BalancedResult
{
    std::uint64_t rays = 0; ///< number cast
    bool solved = false;    ///< if false, the run was stopped, and the light not distributed yet stays unshot
    /// [(W/m^2)^2] of each patch's radiosity, estimated from its own rays; empty unless solved.
    std::vector<Rgb> variance;
};

/// Distributes all unshot power, in scenes of any number of patches. Every patch gets rays in proportion to their
/// expected reduction of the error: shadow rays to the lights (GatheredLight), and rays over its hemisphere. The latter
/// are counted for both of their ends (SparseExchange), and the linear system (R1) of the counts is solved. Two small
/// rounds estimate how many rays each patch needs in the next round; their rays count, too. If all counts would exceed
/// `memory` [bytes] for the whole run, the last round is split into parts, which are solved one by one and averaged. If
/// the run is stopped after the first round, the system is solved with the rays so far. The caller must save `state` in
/// the checkpoint. Throws InputError if the equations have no solution, or if the counts of a shard do not fit into the
/// memory.
BalancedResult reuse_balanced(const Scene& scene, const SceneLights& lights, const Sequence& sequence,
                              const BalancedRays& rays, double memory, const RunControl& run, PowerState& state);

} // namespace multipath
