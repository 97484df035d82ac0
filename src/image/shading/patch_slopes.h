#pragma once

#include "image/shading/visible_patches.h"
#include "scene/rgb.h"

#include <cstddef>
#include <vector>

namespace multipath {

/// Slope of a linear function on a patch. A back patch uses the edges of its front patch.
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

/// Weighted least-squares fit of a linear function that is 0 at the origin, from the normal equations. The coordinates
/// are those of PatchSlope, with z = 0.
class SlopeFit
{
public:
    /// Adds a point where the function should have the value `change`.
    void add(double weight, Vec3 way, Rgb change);
    /// True if all points, as seen from the origin, lie on one line.
    bool on_one_line() const { return determinant() <= 1e-6 * trace() * trace(); }
    /// The fitted slope. If all points lie on one line, the slope across it is 0.
    PatchSlope slope() const;

    Rgb low() const { return low_; }   ///< least value of the points and the origin
    Rgb high() const { return high_; } ///< greatest value of the points and the origin

private:
    double determinant() const { return xx_ * yy_ - xy_ * xy_; }
    double trace() const { return xx_ + yy_; }

    double xx_ = 0.0, xy_ = 0.0, yy_ = 0.0; ///< second moments of the points
    Rgb x_value_;
    Rgb y_value_;
    Rgb low_;
    Rgb high_;
};

/// Reconstructs a linear function on every patch from one value per patch, like a finite volume method. The mean of the
/// function is VisiblePatches::value() of the patch. Its slope is a least-squares fit to the values of the neighbours,
/// the patches across the edges of the patch. A limiter keeps the function, halfway to each neighbour, within the range
/// of the values of the patch and its neighbours (Barth and Jespersen 1989). Neighbours belong to the same surface, and
/// no occluder separates them from the patch. At a border, where neighbours are missing on one side, the slope is
/// extrapolated with a quadratic function through the patch and its neighbours, and limited to lie between 0 and twice
/// the slope of the neighbours. A patch without neighbours has the slope 0.
///
/// `bends`, unless null, receives for each patch the mean, over its neighbours and the channels, of the squared second
/// derivative in the direction of the neighbour. The edges of the patch have unit length: for the function b x^2 / 2, a
/// neighbour along x contributes b^2. The mean is multiplied by 40 at a border, where the slope is uncertain, and is 0
/// for a patch without neighbours.
std::vector<PatchSlope> patch_slopes(const VisiblePatches& patches, int threads, std::vector<double>* bends = nullptr);

} // namespace multipath
