#pragma once

#include "parallel/run_control.h"
#include "radiosity/particles.h"
#include "sampling/sequence.h"

#include <cstdint>

namespace multipath {

struct LocalOptions
{
    std::uint64_t lines = 0; ///< N_l to use, to about 1 %: every segment of a path counts, and their number is random
    Estimator estimator = Estimator::collision;
    std::uint64_t first_item = 0; ///< of the sequence; one item per particle, for its first segment
    std::uint64_t seed = 0;       ///< of all that is random after the first segment
};

/// Phi_T local Monte Carlo (L1): particles of equal power leave the sources, are reflected with the probability rho,
/// and go on from a uniform point of the patch that they hit. Returns the segments cast. Unshot power then holds what
/// Russian roulette created (negative) or destroyed, which is zero in expectation; and, if the run is stopped, that of
/// the particles that did not leave. A checkpoint must hold the state besides what this function makes it hold.
std::uint64_t cast_particles(const Scene& scene, const Sequence& sequence, const LocalOptions& options,
                             const RunControl& run, PowerState& state);

} // namespace multipath
