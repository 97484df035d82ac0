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

} // namespace multipath
