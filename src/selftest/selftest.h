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
    int replicates = 32;           ///< independent runs for each check, at least 2
    std::uint64_t lines = 1 << 15; ///< of every run; methods with much noise take a multiple
    int threads = 1;
};

/// Solves every scene by every method with every sequence of the selftest, and compares the results with the known
/// answers. The checks do not depend on the number of threads.
std::vector<Check> known_scene_checks(const std::vector<KnownScene>& scenes, const SelftestSettings& settings,
                                      const ProgressCallback& progress);

/// Solves a scene without known answers by every method. Checks that no power is gained or lost, that the sources emit
/// their power, that no patch reflects negative power, and that the brightest materials reflect the same power as by
/// local Monte Carlo.
std::vector<Check> scene_checks(const Scene& scene, const SelftestSettings& settings, const ProgressCallback& progress);

} // namespace multipath
