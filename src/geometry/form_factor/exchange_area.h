#pragma once

#include "geometry/polygon.h"
#include "geometry/surface.h"

namespace multipath {

/// Double integral of ln r dx.dy around the borders of both polygons, divided by 2 pi [m^2]; r is the distance
/// between the border elements dx and dy. By Stokes' theorem the result is the exchange area A F of two polygons that
/// lie in front of each other's planes, and the area of the overlap of two polygons in one plane that face opposite
/// ways. The relative error is about 1e-8 for polygons near each other. The absolute error is at least 1e-16 times the
/// squared distance, so no digit is right for tiny polygons far apart.
double contour_integral(const FlatPolygon& a, const FlatPolygon& b);

/// A surface with the precomputed quantities from which exchange areas are computed. Its area must not be zero.
struct FlatPiece
{
    FlatPiece(const Surface& whole); ///< implicit: a surface serves wherever a piece is wanted

    Surface surface;
    Vec3 normal;   ///< unit normal on the front side
    Vec3 centre;   ///< centroid
    double area;   ///< [m^2]; a scene unit counts as a metre
    double radius; ///< [scene units] from the centre to the farthest corner
    /// Uniform random points of the surface have the covariance (u u^T + v v^T) / 12 with u = spread_u and v = spread_v
    /// [scene units]. For a parallelogram they are the edges, for a triangle linear combinations of its edges.
    Vec3 spread_u;
    Vec3 spread_v;
    double squared_spread; ///< u.u + v.v
};

/// Unoccluded exchange area A_a F_ab [m^2], (F1) in docs/equations.md: the integral of cos cos' / (pi r^2) over all
/// pairs of points whose fronts see each other. This is 1 / pi times the measure of the lines from the front of a to
/// the front of b. A corner of one surface within `touching` [scene units] of the plane of the other counts as in the
/// plane. For two surfaces in one plane that face opposite ways, such as the bottom of a box and the floor, the
/// exchange area is the area of the overlap, even if they are back to back, like the two faces of a thin sheet. (a, b)
/// and (b, a) give the same bits.
double exchange_area(const FlatPiece& a, const FlatPiece& b, double touching);

} // namespace multipath
