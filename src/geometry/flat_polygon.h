#pragma once

#include "geometry/surface.h"

#include <array>
#include <cstddef>
#include <vector>

namespace multipath {

/// A flat convex polygon, corners counter-clockwise seen from its front: a surface, or what a plane leaves of one.
struct FlatPolygon
{
    std::array<Vec3, 5> corners; ///< the first `size` count
    std::size_t size = 0;

    bool empty() const { return size == 0; }
    void add(Vec3 corner) { corners[size++] = corner; }
    Vec3 next(std::size_t k) const { return corners[k + 1 < size ? k + 1 : 0]; } ///< corner after number k
};

FlatPolygon polygon_of(const Surface& surface);

/// Of the same polygon, three or four.
std::vector<Vec3> corners_of(const Surface& surface);

/// Lowest and highest corner over the plane through `point` [scene units].
struct HeightRange
{
    double low;
    double high;

    bool within(double limit) const { return low >= -limit && high <= limit; }
};
HeightRange heights(const FlatPolygon& polygon, Vec3 point, Vec3 normal);

/// The part of a surface's polygon in front of a plane; corners less than `touching` behind it count as in front.
/// Empty if nothing but an edge or a corner is left.
FlatPolygon part_in_front(const FlatPolygon& polygon, Vec3 point, Vec3 normal, double touching);

/// The polygon dropped onto a plane along its unit normal.
FlatPolygon projected(FlatPolygon polygon, Vec3 point, Vec3 normal);

} // namespace multipath
