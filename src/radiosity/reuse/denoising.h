#pragma once

#include "scene/rgb.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// Lessens the noise of a solution whose patches err independently of each other. Neighbouring patches of one material
/// are replaced by a polynomial fitted to them where Stein's unbiased risk estimate (1981) says that it is closer to
/// the truth than they are. Blocks of patches come from a binary tree that is pruned from its leaves (Donoho 1997,
/// dyadic CART); the result is the mean over some shifted trees (Coifman and Donoho 1995, cycle spinning). The power of
/// each material stays, to rounding; so do patches without variance. `radiosity` [W/m^2] and its `variance`
/// [(W/m^2)^2], per patch, become those after it. The same bits for any number of threads.
void denoise(const Scene& scene, int threads, std::vector<Rgb>& radiosity, std::vector<Rgb>& variance);

} // namespace multipath
