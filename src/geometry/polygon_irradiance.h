#pragma once

#include "geometry/flat_polygon.h"

namespace multipath {

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

} // namespace multipath
