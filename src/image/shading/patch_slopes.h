#pragma once

#include "image/shading/visible_patches.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Change of a value over a patch: along the whole of its edge_u, and of its edge_v.
struct PatchSlope
{
    Rgb along_u;
    Rgb along_v;

    /// From the middle to corner k of 3 or 4, counter-clockwise from the origin.
    Rgb at_corner(std::size_t k, std::size_t corners) const
    {
        const double middle = corners == 3 ? 1.0 / 3.0 : 0.5;
        const double x = (k == 1 || (k == 2 && corners == 4) ? 1.0 : 0.0) - middle;
        const double y = (k >= 2 ? 1.0 : 0.0) - middle;
        return x * along_u + y * along_v;
    }
};

/// A linear function for every patch, made from one value per patch: its mean is the value of the patch, and its slope
/// a fit by least squares to the values of the patches across its edges, as finite volume methods reconstruct them,
/// limited to what these have (Barth and Jespersen 1989). Neighbours belong to the same surface, and nothing stands
/// between them and the patch. At a border, where the neighbours of one side are missing, the slope is that of the
/// quadratic function that patch and neighbours tell, between 0 and twice that of the neighbours.
///
/// `bends`, if wanted: per patch the square of the change of slope towards a neighbour over one step of the size of the
/// patch, as the mean over neighbours and channels: of b x^2 / 2 per step it is b^2 in the direction of x. 40 times as
/// much at a border, where the slope is a guess. 0 without neighbours.
std::vector<PatchSlope> patch_slopes(const VisiblePatches& patches, int threads, std::vector<double>* bends = nullptr);

} // namespace multipath
