#pragma once

#include "sampling/sequence.h"

#include <vector>

namespace multipath {

/// Points of a sequence in memory.
struct PointSet
{
    int dimensions = 0;
    std::vector<double> coordinates; ///< all coordinates of the first point, then those of the second point, ...

    std::size_t size() const { return coordinates.size() / static_cast<std::size_t>(dimensions); }
    double at(std::size_t point, int dimension) const
    {
        return coordinates[point * static_cast<std::size_t>(dimensions) + static_cast<std::size_t>(dimension)];
    }
};

/// The points first, first + 1, ..., first + count - 1 of a sequence; first + count must not exceed its item_limit().
inline PointSet points_of(const Sequence& sequence, std::uint64_t first, std::uint64_t count)
{
    PointSet points{sequence.dimensions(), {}};
    points.coordinates.reserve(static_cast<std::size_t>(count) * static_cast<std::size_t>(points.dimensions));
    for (std::uint64_t n = first; n < first + count; ++n)
        for (int d = 0; d < points.dimensions; ++d)
            points.coordinates.push_back(sequence.coordinate(n, d));
    return points;
}

// Discrepancy: how far a point set is from uniform. The local discrepancy of a box [0, q) is the fraction of the points
// that lie in the box, minus the volume of the box. The L2 star discrepancy is the root mean square of the local
// discrepancy over all corners q in the unit cube (Warnock, "Computational investigations of low-discrepancy point
// sets", 1972).

/// L2 star discrepancy of N >= 1 points in d dimensions, in O(N^2 d) time.
double l2_star_discrepancy(const PointSet& points);

/// Root mean square of the L2 star discrepancy of N = `count` independent uniform points: sqrt((2^-d - 3^-d) / N), from
/// the variance of the indicator of a box averaged over all boxes.
double random_l2_star_discrepancy(std::size_t count, int dimensions);

} // namespace multipath
