#pragma once

#include "radiosity/paper/local_monte_carlo.h"

#include <cstdint>

namespace multipath {

/// Result of gather_by_walks().
struct GatheringResult
{
    std::uint64_t segments = 0; ///< number of segments cast, about options.lines
    bool solved = false;        ///< true if at least one round was finished; if false, the state is unchanged
};

/// Gathering random walks (Bekaert: Hierarchical and stochastic algorithms for radiosity, 1999, section 4.4; (W1) in
/// docs/equations.md). Walks start at the receivers, which are all patches, and survive with probability rho at each
/// patch that they meet. They gather Scene::first_light() of every patch that they meet (collision estimator), or only
/// of the patch where they end (absorption estimator). They solve the adjoint of the system that shooting walks solve,
/// and the number of walks of a patch does not depend on how much light arrives there.
///
/// `state` must be the initial state of a run; the function adds all light. The walks are divided into 1 ... 16 rounds.
/// Each round covers all patches, except that a patch whose expected number of walks is below 1 may get none. If the
/// run is stopped, the result is, for each patch, the mean over its walks so far; there is no result before the end of
/// the first round. The caller must save `state` in the checkpoint; this function saves the rest.
GatheringResult gather_by_walks(const Scene& scene, const Sequence& sequence, const LocalOptions& options,
                                const RunControl& run, PowerState& state);

/// The walks of the first round. Walk n takes the item options.first_item + n of the sequence. Shot::power_per_ray is
/// not a power here but the weight [1] of a walk: the inverse of the number of walks from its patch, or of the expected
/// number if that is below 1.
Particles first_walks(const Scene& scene, const LocalOptions& options, int threads);

/// [W/m^2] What a step of a walk adds to the irradiance of the patch where the walk starts (W1). Black if the step ends
/// at no patch.
Rgb gathered_irradiance(const Scene& scene, const ParticleStep& step, Estimator estimator);

} // namespace multipath
