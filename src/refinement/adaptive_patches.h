#pragma once

#include "radiosity/solve.h"
#include "scene/scene.h"

#include <cstdint>

namespace multipath {

/// Refines the cells of a scene where the light is not locally linear, into about `most` patches, never more. Each of a
/// few rounds solves the scene by line reuse with few lines, the same for every method and sequence, and splits the
/// patches with the largest estimated errors into four. The error of a patch is its area times the mean square
/// difference between the corner values of smooth shading and the patch's own linear function. Sources are not split.
/// `memory`: [bytes] for solving. The result is the same for any number of threads. Throws InputError if the scene has
/// no solution.
Scene adaptively_refined(const Scene& coarse, std::uint64_t most, double memory, int threads,
                         const ProgressCallback& progress);

} // namespace multipath
