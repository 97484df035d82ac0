#pragma once

#include "geometry/polygon.h"

namespace multipath {

/// Double integral of ln r dx.dy around the borders of both polygons, divided by 2 pi [m^2]; r is the distance
/// between the border elements dx and dy. By Stokes' theorem the result is the exchange area A F of two polygons that
/// lie in front of each other's planes, and the area of the overlap of two polygons in one plane that face opposite
/// ways. The relative error is about 1e-8 for polygons near each other. The absolute error is at least 1e-16 times the
/// squared distance, so no digit is right for tiny polygons far apart.
double contour_integral(const FlatPolygon& a, const FlatPolygon& b);

} // namespace multipath
