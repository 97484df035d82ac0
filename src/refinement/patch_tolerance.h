#pragma once

#include "radiosity/run/solve.h"
#include "scene/scene.h"

#include <functional>

namespace multipath {

/// A scene and the error that its patches cause.
struct RefinedScene
{
    Scene scene;
    double error; ///< [1] upper bound of the root of the relative mean square error (MSE), see patch_error()
};

/// Thrown by a callback of refined_to_error() to keep the patches found so far.
struct EnoughPatches
{
};

/// Cuts the patches by adaptively_refined() until the root of the relative MSE that they cause is at most `wanted` [1].
/// The last error is larger if there are about a million patches, none can be cut further, or a callback throws
/// EnoughPatches. `before_cut` is called before each cut with the number of patches to come; `progress` restarts with
/// each cut, and may throw EnoughPatches from the first one on. `memory` [bytes] is for solving. The result is the same
/// for any number of threads. Throws InputError if the scene has no solution.
RefinedScene refined_to_error(const Scene& coarse, double wanted, const std::function<void(double)>& before_cut,
                              double memory, int threads, const ProgressCallback& progress);

} // namespace multipath
