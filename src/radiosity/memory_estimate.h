#pragma once

#include "scene/scene.h"

namespace multipath {

/// [bytes] that a run takes at its peak for scene and light, whatever the method, but for the pairs of patches of
/// `reuse`, which reuse_bytes() tells. Measured, not derived. Real numbers, for scenes too large to count.
double run_bytes(double surfaces, double patches);

/// [bytes] that it takes while it makes a page to walk through the room, likewise: what people may choose to see, each
/// patch as numbers and as text.
double page_bytes(double surfaces, double patches);

/// [bytes] of `memory` that a run has left for pairs of patches.
double bytes_for_pairs(double memory, const Scene& scene);

} // namespace multipath
