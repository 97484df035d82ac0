#pragma once

#include "geometry/surface.h"
#include "geometry/vec3.h"

#include <array>
#include <cstddef>

namespace multipath {

/// A flat convex polygon of up to five corners, counter-clockwise seen from its front: a surface, or what a plane
/// leaves of one. Without corners it is empty.
struct ConvexPolygon
{
    std::array<Vec3, 5> corners;
    std::size_t count = 0;

    bool empty() const { return count == 0; }
    void append(Vec3 corner) { corners[count++] = corner; }
    Vec3 next(std::size_t k) const { return corners[k + 1 < count ? k + 1 : 0]; } ///< corner after number k
};

ConvexPolygon outline(const Surface& surface);

/// What of the surface lies in front of the plane through `point` with this unit normal. Closer to the plane than
/// rounding can tell counts as in it.
ConvexPolygon part_in_front(const Surface& surface, Vec3 point, Vec3 normal);

/// Is the point, in the plane of a polygon that is not empty, inside or on the border?
bool contains(const ConvexPolygon& polygon, Vec3 point);

/// [scene units] From the point to the nearest point of a polygon that is not empty.
double distance(Vec3 point, const ConvexPolygon& polygon);

/// [1] Irradiance at a point with this unit normal if the front of the polygon has a radiosity of 1: the point's form
/// factor, by Lambert's formula. Nothing of the polygon may lie behind the point's horizon. 0 for a point behind it.
double irradiance_from(const ConvexPolygon& polygon, Vec3 point, Vec3 normal);

} // namespace multipath
