#pragma once

#include "parallel/run_control.h"
#include "radiosity/power_state.h"
#include "sampling/sequence.h"
#include "transport/exchange/unoccluded_exchange.h"
#include "transport/lines/global_lines.h"

#include <cstdint>

namespace multipath {

/// The lines and rays of a line reuse.
struct ReusedLines
{
    std::uint64_t first_line_item = 0; ///< of the sequence, for the global lines
    std::uint64_t cast = 0;            ///< number of global lines; below 2^32
    std::uint64_t first_ray_item = 0;  ///< of the sequence, for the rays
    std::uint64_t rays = 0;            ///< number of rays between pairs of patches
    std::uint64_t seed = 0;            ///< of the rounding to whole rays
};

/// [bytes] Memory that reuse_lines() needs for its pairs of patches. Pairs of surfaces take more than half of it if
/// there are almost as many surfaces as patches.
double reuse_bytes(const Scene& scene);

/// Distributes all unshot power by line reuse. Global lines show which patches see each other and how well, rays refine
/// the pairs that matter, and the linear system (R1) is solved instead of carrying power along the lines. `unoccluded`:
/// see UnoccludedExchange. Returns the number of global lines cast, fewer if the run is stopped: then the system is
/// solved with their counts, except in a shard. The caller must save `state` in the checkpoint. Throws InputError if
/// the equations have no solution.
std::uint64_t reuse_lines(const Scene& scene, const UnoccludedExchange& unoccluded, const GlobalLines& lines,
                          const Sequence& sequence, const ReusedLines& plan, const RunControl& run, PowerState& state);

} // namespace multipath
