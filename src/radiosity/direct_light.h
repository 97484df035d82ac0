#pragma once

#include "scene/scene.h"

#include <cstdint>

namespace multipath {

/// What the sources light directly.
struct DirectLight
{
    double lit_fraction = 0.0;          ///< [1] f: area of the patches that receive any direct light / A_T
    double effective_fraction = 0.0;    ///< [1] (sum A b)^2 / (A_T sum A b^2) of the direct radiosity b
    double secondary_reflectance = 0.0; ///< [1] R_s': mean reflectance of what is lit, weighted by the power received
};

/// Measured with up to `most_rays` rays from the sources and as many shadow rays between patches and sources, fewer
/// where faces lie on the sources by the hundred. Deterministic.
DirectLight measure_direct_light(const Scene& scene, std::uint64_t most_rays, int threads);

} // namespace multipath
