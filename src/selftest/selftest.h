#pragma once

#include "radiosity/solve.h"
#include "selftest/check.h"
#include "selftest/known_scenes.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// The effort of a selftest.
struct SelftestSettings
{
    std::uint64_t seed = 1;
    int replicates = 32; ///< number of independent runs for each check, at least 2
    /// Number of lines of every run. A run by `gathering`, which is noisy, takes 4 times as many in
    /// known_scene_checks(), and 16 times as many in scene_checks().
    std::uint64_t lines = 1 << 15;
    int threads = 1;
};

/// Solves every scene by every method with every sequence of the selftest (SequenceKind::in_selftest), and compares the
/// results with the known answers. Also checks that no power is gained or lost. The checks come scene by scene, and for
/// each scene method by method. They do not depend on the number of threads. `progress` gets the finished share of the
/// work.
std::vector<Check> known_scene_checks(const std::vector<KnownScene>& scenes, const SelftestSettings& settings,
                                      const ProgressCallback& progress);

/// Solves a scene without known answers by every method, with the sequence sobol-owen. Checks for each method that no
/// power is gained or lost, that the sources emit their power, and that no patch reflects negative power. The power
/// that each of the brightest materials reflects (at most four, those that reflect most) must agree with the result of
/// local Monte Carlo. `progress` gets the finished share of the work.
std::vector<Check> scene_checks(const Scene& scene, const SelftestSettings& settings, const ProgressCallback& progress);

} // namespace multipath
