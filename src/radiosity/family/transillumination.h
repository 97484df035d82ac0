#pragma once

#include "parallel/run_control.h"
#include "radiosity/power_state.h"
#include "sampling/sequence.h"

#include <cstdint>

namespace multipath {

struct TransilluminationOptions
{
    std::uint64_t first_item = 0; ///< of the sequence; one item per ray, then one per direction
    std::uint64_t lines = 0;      ///< to be used; those that miss the scene's box are free (N1)
    std::uint64_t bundle =
        256;                ///< parallel lines of each direction; fewer where there would be less than 16 directions
    std::uint64_t seed = 0; ///< of the rounding of rays
};

/// Transillumination (Szirmay-Kalos, Foris, Neumann, Csebfalvi 1997; with many lines, ray bundles, Szirmay-Kalos and
/// Purgathofer 1998) of what `state` holds unshot: the iterations of stochastic_jacobi.h, in which T P comes from
/// parallel lines through the whole scene, in directions of the sequence. Along each direction all patches exchange
/// what they send, both ways (P1). Begins with an estimate of all light by rays from the patches, for which an eighth
/// of the lines is used. Returns how many lines were used; fewer if the run is stopped: an iteration that was not
/// finished tells nothing. A checkpoint must hold the state besides what this function makes it hold.
std::uint64_t iterate_by_bundles(const Scene& scene, const Sequence& sequence, const TransilluminationOptions& options,
                                 const RunControl& run, PowerState& state);

} // namespace multipath
