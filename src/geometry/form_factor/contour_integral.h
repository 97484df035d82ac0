#pragma once

#include "geometry/polygon.h"

namespace multipath {

/// 1 / (2 pi) times the integral of ln r dx.dy around both polygons [m^2]: by Stokes' theorem the exchange area A F of
/// polygons in front of each other's planes, and the overlap of two in one plane that face opposite ways.
/// Relative error about 1e-8 of pieces near each other; the absolute error is at least 1e-16 times the squared
/// distance, so that of specks far away nothing is left.
double contour_integral(const FlatPolygon& a, const FlatPolygon& b);

} // namespace multipath
