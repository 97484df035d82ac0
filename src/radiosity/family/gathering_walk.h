#pragma once

#include "radiosity/paper/local_monte_carlo.h"
#include "radiosity/run/run.h"

namespace multipath {

/// Gathering random walks (Bekaert: Hierarchical and stochastic algorithms for radiosity, 1999, section 4.4; (W1) in
/// docs/equations.md). Walks start at the receivers, which are all patches, and survive with probability rho at each
/// patch that they meet. They gather Scene::first_light() of every patch that they meet (collision estimator), or only
/// of the patch where they end (absorption estimator). They solve the adjoint of the system that shooting walks solve,
/// and the number of walks of a patch does not depend on how much light arrives there.
///
/// The walks are divided into 1 ... 16 rounds. Each round covers all patches, except that a patch whose expected number
/// of walks is below 1 may get none. If the run is stopped, an unfinished round has no effect, and without a finished
/// one the run is not solved. A Stage, the only one of its method.
void gather_by_walks(Run& run);

/// The walks of the first round. Walk n takes the item n after the skipped ones of the sequence. Shot::power_per_ray is
/// not a power here but the weight [1] of a walk: the inverse of the number of walks from its patch, or of the expected
/// number if that is below 1.
Particles first_walks(const Run& run);

/// [W/m^2] What a step of a walk adds to the irradiance of the patch where the walk starts (W1). Black if the step ends
/// at no patch.
Rgb gathered_irradiance(const Scene& scene, const ParticleStep& step, Estimator estimator);

} // namespace multipath
