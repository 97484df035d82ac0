#pragma once

#include "parallel/run_control.h"
#include "radiosity/family/importance.h"
#include "radiosity/paper/power_state.h"
#include "radiosity/reuse/gathered_light.h"
#include "sampling/sequence.h"

#include <cstdint>

namespace multipath {

/// Parameters of balanced reuse.
struct BalancedRays
{
    std::uint64_t first_item = 0; ///< ray k takes item (point) first_item + k of the sequence
    std::uint64_t rays = 0;       ///< number of rays, at least min_balanced_rays()
    bool direct = true;           ///< true: distributes the light of the sources; false: this was done before
    bool indirect = true;         ///< true: distributes the reflected light; false: the reflected light stays unshot
    const Importance* importance = nullptr; ///< if set, the patches that matter get more rays (I1); null: all are equal
};

/// Minimum number of rays for balanced reuse, 8 per patch. With fewer, particles are as exact, and unbiased.
std::uint64_t min_balanced_rays(const Scene& scene);

/// [bytes] Lower bound of the total memory of a run with balanced reuse, without the light cuts (LightCuts).
double min_balanced_bytes(const Scene& scene);

/// Result of reuse_balanced().
struct BalancedResult
{
    std::uint64_t rays = 0; ///< number of rays planned so far; all of them were cast unless the run was stopped
    /// False if the run was stopped without a solution (see reuse_balanced()); light not distributed yet stays unshot.
    bool solved = false;
    /// [(W/m^2)^2] per patch: variance of its radiosity, estimated from its own rays and those of the surrounding
    /// patches; empty unless solved.
    std::vector<Rgb> variance;
};

/// Distributes all unshot power by line reuse without a table of pairs, in scenes of any number of patches. Every patch
/// gets rays of two kinds: shadow rays to the lights (GatheredLight), and rays over its hemisphere. Their numbers are
/// chosen to make the expected error small (Neyman allocation). The rays over the hemisphere are counted for both of
/// their ends (LineCounts, SparseExchange), and the linear system of the counts is solved (solve_exchange).
///
/// The rays are cast in three rounds. Two small rounds estimate how many rays each patch needs in the next round; their
/// rays enter the result as well. If the counts of all rays would make the run exceed `memory` [bytes], the last round
/// is split into parts, which are solved one by one and averaged.
///
/// If the run is stopped, the system is solved with the rays cast so far, except in the first round, in a shard, and
/// after the first of several parts has been solved. The caller must save `state` in the checkpoint; this function
/// saves the rest. Throws InputError if the equations have no solution, or if the counts of a shard do not fit into the
/// memory.
BalancedResult reuse_balanced(const Scene& scene, const SceneLights& lights, const Sequence& sequence,
                              const BalancedRays& rays, double memory, const RunControl& run, PowerState& state);

} // namespace multipath
