#pragma once

#include "geometry/surface.h"

namespace multipath {

/// A surface with the precomputed quantities that every exchange area needs.
struct FlatPiece
{
    Surface surface;
    Vec3 normal;
    Vec3 centre;
    double area = 0.0;   ///< [m^2]
    double radius = 0.0; ///< [scene units] from the centre to the farthest corner
    /// Uniform random points of the surface have the covariance (u u^T + v v^T) / 12, u and v these vectors.
    Vec3 spread_u;
    Vec3 spread_v;
    double squared_spread = 0.0; ///< u.u + v.v
};

FlatPiece piece_of(const Surface& surface);

/// Unoccluded exchange area A_a F_ab [m^2] (F1): the integral of cos cos' / (pi r^2) over all pairs of points whose
/// fronts see each other, which is 1 / pi times the measure of the lines from the front of a to the front of b. Corners
/// within `touching` [scene units] of the other's plane count as in it. For two surfaces in one plane that face
/// opposite ways, such as the bottom of a box and the floor, it is the area of the overlap. (a, b) and (b, a) give the
/// same bits.
double exchange_area(const FlatPiece& a, const FlatPiece& b, double touching);
double exchange_area(const Surface& a, const Surface& b, double touching);

} // namespace multipath
