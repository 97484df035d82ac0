#pragma once

#include "parallel/run_control.h"
#include "radiosity/paper/power_state.h"
#include "sampling/sequence.h"
#include "transport/exchange/pair_counts.h"
#include "transport/exchange/pair_rays.h"
#include "transport/lines/global_lines.h"

#include <cstdint>
#include <future>

namespace multipath {

/// The numbers of lines and rays that reuse_lines() casts, and the items of the sequence (its points) that they use.
struct ReusedLines
{
    std::uint64_t first_line_item = 0; ///< index in the sequence of the first global line's item
    std::uint64_t cast = 0;            ///< number of global lines; below 2^32
    PairRays rays;                     ///< rays between pairs of patches
};

/// Number of lines, 4 per patch, from which reuse_lines() is to be preferred to particles: it knows what patches
/// exchange without obstacles.
std::uint64_t min_table_lines(const Scene& scene);

/// [bytes] Memory that reuse_lines() needs for its tables of pairs of patches and of pairs of blocks of patches
/// (estimation_bytes()). The blocks take most of it if nearly every surface is one patch.
double reuse_bytes(const Scene& scene);

/// Distributes all unshot power (emitted or reflected, not yet sent on) by line reuse. Global lines estimate how much
/// each pair of patches exchanges, and rays refine the estimates of pairs that exchange much light and are partly
/// occluded. Then the linear system of the radiosities is solved, (R1) in docs/equations.md.
///
/// `unoccluded` is the matrix of unoccluded_exchange(), which is needed only after the lines.
/// Returns the number of global lines cast: plan.cast, or fewer if the run is stopped. A stopped run still solves the
/// system with the lines cast so far. A run that is a shard (RunControl) stops before that: its counts of lines, or the
/// estimates that its rays refined, are in the checkpoint, and `state` remains unchanged. The caller must save `state`
/// in the checkpoint; this function saves the rest. Throws InputError if (R1) has no solution.
std::uint64_t reuse_lines(const Scene& scene, const std::shared_future<PairMatrix<float>>& unoccluded,
                          const GlobalLines& lines, const Sequence& sequence, const ReusedLines& plan,
                          const RunControl& run, PowerState& state);

} // namespace multipath
