#pragma once

#include "geometry/flat_piece.h"

namespace multipath {

/// A_a F_ab [m^2] with nothing in between (F1): the integral of cos cos' / (pi r^2) over the pairs of points whose
/// fronts see each other, which is 1 / pi times the measure of the lines from the front of a to that of b. Corners
/// within `touching` [scene units] of the other's plane count as in it; of two pieces in one plane that face opposite
/// ways, as a box's bottom and the floor, it is the area of the overlap. The same bits for (b, a).
double exchange_area(const FlatPiece& a, const FlatPiece& b, double touching);
double exchange_area(const Surface& a, const Surface& b, double touching);

} // namespace multipath
