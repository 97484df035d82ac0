#pragma once

#include "scene/rgb.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// Reduces the noise of a solution whose patches have independent errors. A polynomial fit replaces a block of
/// neighbouring patches of one material where its estimated risk is lower (Stein's unbiased risk estimate, 1981). The
/// blocks come from a binary tree that is pruned from its leaves (dyadic CART, Donoho 1997); the result is the mean
/// over several shifted trees (cycle spinning, Coifman and Donoho 1995). The power of each material is preserved up to
/// rounding, and patches without variance do not change. Replaces `radiosity` [W/m^2] and its `variance` [(W/m^2)^2],
/// one entry per patch each. The result has the same bits for any number of threads.
void denoise(const Scene& scene, int threads, std::vector<Rgb>& radiosity, std::vector<Rgb>& variance);

} // namespace multipath
