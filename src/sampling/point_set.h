#pragma once

#include "sampling/sequence.h"

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

} // namespace multipath
