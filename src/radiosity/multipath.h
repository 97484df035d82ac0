#pragma once

#include "parallel/run_control.h"
#include "radiosity/power_state.h"
#include "radiosity/shooting.h"
#include "sampling/sequence.h"
#include "transport/line_sampling.h"

#include <cstdint>

namespace multipath {

/// Which lines a global pass casts.
struct GlobalPass
{
    std::uint64_t first_item = 0; ///< of the sequence
    std::uint64_t lines_cast = 0; ///< N_cast of (N1)
    bool bidirectional = true;    ///< (M2); otherwise power flows only in the direction of the line
};

/// The global pass: distributes the unshot power of all patches with global lines. Traced by all threads, exchanged in
/// the order of the lines, so the result does not depend on the number of threads. Returns how many lines were cast:
/// fewer if the run is stopped, and then what they brought stands for all.
std::uint64_t cast_global_lines(const Scene& scene, const GlobalLines& lines, const Sequence& sequence,
                                const GlobalPass& pass, const RunControl& run, PowerState& state);

} // namespace multipath
