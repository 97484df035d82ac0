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

/// What of the surface the points of the plane through `point` with this unit normal can see: its part in front. Closer
/// to the plane than rounding can tell counts as in it.
FlatPolygon part_above_horizon(const Surface& surface, Vec3 point, Vec3 normal);

/// Is the point, in the plane of a polygon that is not empty, inside or on the border?
bool contains(const FlatPolygon& polygon, Vec3 point);

/// [scene units] From the point to the nearest point of a polygon that is not empty.
double distance(Vec3 point, const FlatPolygon& polygon);

/// [1] Irradiance at a point with this unit normal if the front of the polygon has a radiosity of 1: the point's form
/// factor, by Lambert's formula. Nothing of the polygon may lie behind the point's horizon. 0 for a point behind it.
double irradiance_from(const FlatPolygon& polygon, Vec3 point, Vec3 normal);

/// The same for any number of corners, not limited to 0 ... 1: below 0 for a polygon that is seen from behind.
double lambert_sum(const Vec3* corners, std::size_t count, Vec3 point, Vec3 normal);

} // namespace multipath
