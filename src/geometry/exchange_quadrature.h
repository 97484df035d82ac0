#pragma once

#include "geometry/flat_piece.h"

namespace multipath {

// For pieces that lie wholly in front of each other's planes. `radii`: those of the larger piece.

/// A F [m^2] of pieces far apart: the kernel cos cos' / (pi r^2) between the centres and its curvature. The relative
/// error falls with the fourth power of distance / size; at 18 radii it is about 2e-5.
double exchange_of_far(const FlatPiece& a, const FlatPiece& b);

/// A F [m^2] as a sum of the kernel over points of both; at 4.5 radii the relative error is about 1e-5.
double exchange_by_points(const FlatPiece& a, const FlatPiece& b);

} // namespace multipath
