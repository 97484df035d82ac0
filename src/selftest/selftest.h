#pragma once

#include "radiosity/solve.h"
#include "selftest/check.h"
#include "selftest/known_scenes.h"

#include <cstdint>
#include <vector>

namespace multipath {

struct SelftestSettings
{
    std::uint64_t seed = 1;
    int replicates = 32;           ///< independent runs of a check, at least 2
    std::uint64_t lines = 1 << 15; ///< of every run
    int threads = 1;
};

/// Solves every scene by every method with every sequence that is checked, and compares with the known answers. The
/// checks do not depend on the number of threads.
std::vector<Check> known_scene_checks(const std::vector<KnownScene>& scenes, const SelftestSettings& settings,
                                      const ProgressCallback& progress);

/// Solves a scene of unknown light by every method. Checks that no power is gained or lost, that no patch reflects less
/// than nothing, and that every material reflects the same power as by local Monte Carlo.
std::vector<Check> scene_checks(const Scene& scene, const SelftestSettings& settings, const ProgressCallback& progress);

} // namespace multipath
