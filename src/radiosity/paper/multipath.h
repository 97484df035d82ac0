#pragma once

#include "parallel/run_control.h"
#include "radiosity/paper/power_state.h"
#include "sampling/sequence.h"
#include "transport/lines/global_lines.h"

#include <cstdint>

// The multi-path method. A global line crosses the whole scene and meets many patches. It joins two patches if it
// leaves the front of one and arrives next at the front of the other. Every pair that it joins exchanges power, in both
// directions at once, so that one line carries one segment of many light paths.
//
// Along each line that leaves its front, a patch sends two things. The first is all power that it has received and
// reflected since it last sent (M1); after this the patch holds nothing. The second is the forecast (G3): the unshot
// power (emitted or reflected, but not sent yet) that the patch had at the beginning of the pass, divided by the
// expected number of lines that leave its front. No cosine and no 1/r^2 appear anywhere: the density of the lines
// contains both (G1). Labels are explained in docs/equations.md.

namespace multipath {

/// The global lines of a pass.
struct GlobalPass
{
    std::uint64_t first_item = 0; ///< line k takes item (point) first_item + k of the sequence, which may be shuffled
    std::uint64_t lines_cast = 0; ///< number of lines to cast, including those that miss the scene (N1)
    bool bidirectional = true;    ///< power flows both ways (M2); if false, only in the direction of the line
};

/// The global pass: distributes the unshot power of all patches by global lines. All threads trace; the exchanges are
/// made in the order of the lines, so the result does not depend on the number of threads. Returns the number of lines
/// cast. If the run is stopped, fewer lines than planned are cast, and the result is scaled up to all lines. The caller
/// must save `state` in the checkpoint; this function saves the rest.
std::uint64_t cast_global_lines(const Scene& scene, const GlobalLines& lines, const Sequence& sequence,
                                const GlobalPass& pass, const RunControl& run, PowerState& state);

} // namespace multipath
