#pragma once

#include "parallel/run_control.h"
#include "radiosity/power_state.h"
#include "sampling/sequence.h"
#include "transport/exchange/unoccluded_exchange.h"
#include "transport/lines/global_lines.h"

#include <cstdint>

namespace multipath {

/// The lines of a reuse.
struct ReusedLines
{
    std::uint64_t first_line_item = 0; ///< of the sequence, for the global lines
    std::uint64_t cast = 0;            ///< global lines; below 2^32
    std::uint64_t first_ray_item = 0;  ///< of the sequence, for the rays
    std::uint64_t rays = 0;            ///< between pairs of patches
    std::uint64_t seed = 0;            ///< of the rounding to whole rays
};

/// Bytes that reuse_lines needs for its pairs of patches. More than half of them are for pairs of surfaces where those
/// are almost as many as patches.
double reuse_bytes(const Scene& scene);

/// Distributes all unshot power: global lines tell which patches see each other and how well, rays look closer at the
/// pairs that matter, and the light is found by solving for it (R1) instead of carrying it along the lines.
/// `unoccluded`: see unoccluded_exchange. Returns how many global lines were cast: fewer if the run is stopped, and
/// then the light is solved for with what these told. A checkpoint must hold the state, too.
std::uint64_t reuse_lines(const Scene& scene, const UnoccludedExchange& unoccluded, const GlobalLines& lines,
                          const Sequence& sequence, const ReusedLines& plan, const RunControl& run, PowerState& state);

} // namespace multipath
