#pragma once

#include "radiosity/local_monte_carlo.h"

#include <cstdint>

namespace multipath {

struct GatheringResult
{
    std::uint64_t segments = 0; ///< cast, about options.lines
    bool solved = false;        ///< all patches were asked; otherwise the state is as it was
};

/// Gathering random walks (Bekaert: Hierarchical and stochastic algorithms for radiosity, 1999, section 4.4): paths
/// leave the patches whose light is asked for, are reflected with the probability rho, and bring back what the sources
/// emit where they pass (collision estimator) or end (absorption estimator) (W1). The transposed system of that of
/// shooting walks: what one knows of a patch costs the same whether much or little light arrives there. They ask all
/// patches in up to 16 rounds: a run that is stopped has the mean of what it did, and in the first round solves
/// nothing. A checkpoint must hold the state besides what this function makes it hold.
GatheringResult gather_by_walks(const Scene& scene, const Sequence& sequence, const LocalOptions& options,
                                const RunControl& run, PowerState& state);

} // namespace multipath
