#pragma once

#include "radiosity/solve.h"
#include "scene/scene.h"

#include <cstdint>

namespace multipath {

/// The scene with its cells cut further where the light changes in ways that linear functions do not follow, into about
/// `most` patches, never more. Some rounds solve it by line reuse with few lines, the same for every method and
/// sequence, and cut those patches into four of which shading finds the largest error: area times the square of what
/// the shared corner values differ from the patch's own linear function. Sources stay whole. `memory`: [bytes] that
/// solving may take. The same patches for any number of threads. Throws InputError where the scene has no solution.
Scene adapted(const Scene& coarse, std::uint64_t most, double memory, int threads, const ProgressCallback& progress);

} // namespace multipath
