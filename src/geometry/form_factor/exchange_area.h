#pragma once

#include "geometry/surface.h"

namespace multipath {

/// A surface with what its exchange with others asks for again and again.
struct FlatPiece
{
    Surface surface;
    Vec3 normal;
    Vec3 centre;
    double area = 0.0;   ///< [m^2]
    double radius = 0.0; ///< [scene units] from the centre to the farthest corner
    /// Uniform points of the surface scatter about the centre with covariance (u u^T + v v^T) / 12.
    Vec3 spread_u;
    Vec3 spread_v;
    double squared_spread = 0.0; ///< u.u + v.v
};

FlatPiece piece_of(const Surface& surface);

/// A_a F_ab [m^2] with nothing in between (F1): the integral of cos cos' / (pi r^2) over the pairs of points whose
/// fronts see each other, which is 1 / pi times the measure of the lines from the front of a to that of b. Corners
/// within `touching` [scene units] of the other's plane count as in it; of two pieces in one plane that face opposite
/// ways, as a box's bottom and the floor, it is the area of the overlap. The same bits for (b, a).
double exchange_area(const FlatPiece& a, const FlatPiece& b, double touching);
double exchange_area(const Surface& a, const Surface& b, double touching);

} // namespace multipath
