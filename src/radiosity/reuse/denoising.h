#pragma once

#include "scene/rgb.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// Reduces the noise of a solution whose patches have independent errors. A polynomial fit replaces the radiosities in
/// a block of neighbouring patches of one material and side, if the estimated risk of this fit (Stein's unbiased risk
/// estimate, 1981) is less than that of the two halves of the block. The blocks come from a binary tree that is pruned
/// from its leaves (dyadic CART, Donoho 1997); the result is the mean over several shifted trees (cycle spinning,
/// Coifman and Donoho 1995). Textures and sunlight are removed before the fit, and added again afterwards. Up to
/// rounding, the power of each untextured material is preserved, and patches without variance do not change. Replaces
/// `radiosity` [W/m^2] and its `variance` [(W/m^2)^2], which have one entry per patch. The result has the same bits for
/// any number of threads.
void denoise(const Scene& scene, int threads, std::vector<Rgb>& radiosity, std::vector<Rgb>& variance);

} // namespace multipath
