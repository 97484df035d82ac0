#pragma once

#include "radiosity/local_monte_carlo.h"

#include <cstdint>

namespace multipath {

struct GatheringResult
{
    std::uint64_t segments = 0; ///< number cast, about options.lines
    bool solved = false;        ///< true if at least one round was finished; otherwise the state is unchanged
};

/// Gathering random walks (Bekaert: Hierarchical and stochastic algorithms for radiosity, 1999, section 4.4). Paths
/// start at the patches whose light is sought, are reflected with probability rho, and gather the emittance of the
/// sources where they pass (collision estimator) or end (absorption estimator) (W1). They solve the adjoint of the
/// system that shooting walks solve: the precision of a patch costs the same whether much or little light arrives
/// there. Every one of up to 16 rounds covers all patches. A run that is stopped has the mean of its rounds so far, and
/// no result during the first one. The caller must save `state` in the checkpoint; this function saves the rest.
GatheringResult gather_by_walks(const Scene& scene, const Sequence& sequence, const LocalOptions& options,
                                const RunControl& run, PowerState& state);

/// The walks of the first round. Walk n takes the item options.first_item + n.
Particles first_walks(const Scene& scene, const LocalOptions& options, int threads);

/// [W/m^2] What a step of a walk adds to the irradiance of the patch where the walk starts (W1); black if the step ends
/// at no patch.
Rgb gathered_irradiance(const Scene& scene, const ParticleStep& step, Estimator estimator);

} // namespace multipath
