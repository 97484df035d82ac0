#pragma once

#include "scene/scene.h"

namespace multipath {

/// [bytes] Peak memory of a run for scene and light, whatever the method, without the pairs of patches of `reuse` (see
/// reuse_bytes()). An empirical formula. Takes real numbers, since estimated sizes may exceed the integer types.
double run_bytes(double surfaces, double patches);

/// [bytes] The same for making an interactive page: all quantities that it can show, each patch as numbers and as text.
double page_bytes(double surfaces, double patches);

/// [bytes] Part of `memory` that a run can use for pairs of patches.
double bytes_for_pairs(double memory, const Scene& scene);

} // namespace multipath
