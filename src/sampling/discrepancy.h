#pragma once

#include "sampling/sequence.h"

#include <optional>

namespace multipath {

/// Points of a sequence, for work that needs them all at once.
struct PointSet
{
    int dimensions = 0;
    std::vector<double> coordinates; ///< point by point

    std::size_t size() const { return coordinates.size() / static_cast<std::size_t>(dimensions); }
    double at(std::size_t point, int dimension) const
    {
        return coordinates[point * static_cast<std::size_t>(dimensions) + static_cast<std::size_t>(dimension)];
    }
};

/// The points first, first + 1, ..., first + count - 1 <= item_limit() - 1.
inline PointSet points_of(const Sequence& sequence, std::uint64_t first, std::uint64_t count)
{
    PointSet points{sequence.dimensions(), {}};
    points.coordinates.reserve(static_cast<std::size_t>(count) * static_cast<std::size_t>(points.dimensions));
    for (std::uint64_t n = first; n < first + count; ++n)
        for (int d = 0; d < points.dimensions; ++d)
            points.coordinates.push_back(sequence.coordinate(n, d));
    return points;
}

// How far a point set is from uniform. For every box [0, q) the local discrepancy is the share of the points in it
// minus its volume; the measures differ in how they sum up over all corners q. Sources: Warnock, "Computational
// investigations of low-discrepancy point sets" (1972); Niederreiter, "Random number generation and quasi-Monte Carlo
// methods" (1992), theorem 2.6; De Clerck, "A method for exact calculation of the star discrepancy of plane sets"
// (1986).

/// Root of the mean square of the local discrepancy over all boxes. Takes time of order N^2 d.
double l2_star_discrepancy(const PointSet& points);

/// What independent random points have in root mean square: sqrt((2^-d - 3^-d) / N), the variance of "is the point in
/// the box" averaged over all boxes.
double random_l2_star_discrepancy(std::size_t count, int dimensions);

/// The largest local discrepancy, exact; time of order N log N in one dimension, N^2 in two. Absent for more.
std::optional<double> star_discrepancy(const PointSet& points);

} // namespace multipath
