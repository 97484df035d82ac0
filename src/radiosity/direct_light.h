#pragma once

#include "scene/scene.h"

#include <cstdint>

namespace multipath {

/// Figures of the direct illumination of a scene, for the optimal ratio (3).
struct DirectLight
{
    double lit_fraction = 0.0;       ///< [1] f: area of the patches that receive any direct light / A_T
    double effective_fraction = 0.0; ///< [1] (sum A b)^2 / (A_T sum A b^2) of the direct radiosity b
    double secondary_reflectance =
        0.0; ///< [1] R_s': mean reflectance of the lit patches, weighted by the received power
};

/// Estimates the figures by at most `most_rays` rays from the sources, and at most eight times as many shadow rays
/// between patches and sources (but up to 16 for every patch that is tested). Casts fewer where hundreds of faces lie
/// on the sources. Deterministic.
DirectLight measure_direct_light(const Scene& scene, std::uint64_t most_rays, int threads);

} // namespace multipath
