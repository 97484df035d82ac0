#pragma once

#include "sampling/point_set.h"

#include <optional>

// How far a point set is from uniform. For every box [0, q) the local discrepancy is the share of the points in it
// minus its volume; the measures differ in how they sum up over all corners q. Sources: Warnock, "Computational
// investigations of low-discrepancy point sets" (1972); Niederreiter, "Random number generation and quasi-Monte Carlo
// methods" (1992), theorem 2.6; De Clerck, "A method for exact calculation of the star discrepancy of plane sets"
// (1986).

namespace multipath {

/// Root of the mean square of the local discrepancy over all boxes. Takes time of order N^2 d.
double l2_star_discrepancy(const PointSet& points);

/// What independent random points have in root mean square: sqrt((2^-d - 3^-d) / N), the variance of "is the point in
/// the box" averaged over all boxes.
double random_l2_star_discrepancy(std::size_t count, int dimensions);

/// The largest local discrepancy, exact; time of order N log N in one dimension, N^2 in two. Absent for more.
std::optional<double> star_discrepancy(const PointSet& points);

} // namespace multipath
