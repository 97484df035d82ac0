#pragma once

#include "radiosity/run/solve.h"
#include "scene/scene.h"

#include <cstdint>

namespace multipath {

/// Splits the cells of a scene into four where the light is not locally linear, until there are about `most` patches.
/// There are never more, but fewer if four rounds do not suffice or too few cells have a noticeable error. A scene that
/// already has `most` patches or more is returned unchanged. Each of at most four rounds solves the scene by line reuse
/// with 8 to 32 lines per patch, whatever method and sequence the final run uses, and splits the cells with the largest
/// estimated errors. A source that reflects nothing is not split. `memory` [bytes]: SolveOptions::memory of each
/// solution. The result is the same for any number of threads. Throws InputError if the scene has no solution.
Scene adaptively_refined(const Scene& coarse, std::uint64_t most, double memory, int threads,
                         const ProgressCallback& progress);

} // namespace multipath
