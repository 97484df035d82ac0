#pragma once

#include "scene/scene.h"

#include <cstdint>

namespace multipath {

/// Figures of the direct illumination of a scene, for the optimal ratio of local to global lines (optimal_ratio). A_T
/// is the total area of the scene. Colours enter as the mean of their channels. With a sun, sunlit patches are sources
/// of the light that they reflect; the sunlight itself counts as received power, but not for lit_fraction.
struct DirectLight
{
    double lit_fraction = 0.0; ///< [1] f: area of the patches that receive any direct light, over A_T
    /// [1] R_s': mean reflectance of the lit patches, weighted by the power that they receive from the sources.
    double secondary_reflectance = 0.0;
};

/// Estimates the figures by `most_rays` rays from the sources, and by shadow rays between sources and patches: at most
/// 8 * most_rays, or 16 per tested patch if that is more. If there are very many patches, only a sample of them is
/// tested. Deterministic.
DirectLight measure_direct_light(const Scene& scene, std::uint64_t most_rays, int threads);

} // namespace multipath
