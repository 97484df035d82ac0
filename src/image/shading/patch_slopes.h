#pragma once

#include "image/shading/visible_patches.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Slope of a linear function on a patch.
struct PatchSlope
{
    Rgb along_u; ///< change over the whole length of edge_u
    Rgb along_v; ///< change over the whole length of edge_v

    /// Change from the centroid to corner k of 3 or 4, counter-clockwise from the origin.
    Rgb at_corner(std::size_t k, std::size_t corners) const
    {
        const double middle = corners == 3 ? 1.0 / 3.0 : 0.5;
        const double x = (k == 1 || (k == 2 && corners == 4) ? 1.0 : 0.0) - middle;
        const double y = (k >= 2 ? 1.0 : 0.0) - middle;
        return x * along_u + y * along_v;
    }
};

/// Reconstructs a linear function on every patch from one value per patch, like a finite volume method. The mean of the
/// function is the value of the patch. Its slope is a least-squares fit to the values of the patches across its edges,
/// limited to their range (Barth and Jespersen 1989). Neighbours belong to the same surface and are not occluded from
/// the patch. At a border, where neighbours are missing on one side, the slope is extrapolated with a quadratic
/// function through patch and neighbours, and limited to lie between 0 and twice the slope of the neighbours.
///
/// `bends`, unless null, receives per patch the mean square of the second derivative towards its neighbours, over
/// neighbours and channels, with the patch size as unit of length: b^2 along x for the function b x^2 / 2. It is
/// multiplied by 40 at a border, where the slope is uncertain, and 0 for a patch without neighbours.
std::vector<PatchSlope> patch_slopes(const VisiblePatches& patches, int threads, std::vector<double>* bends = nullptr);

} // namespace multipath
