#pragma once

#include "geometry/surface.h"

#include <array>
#include <cstddef>
#include <vector>

namespace multipath {

/// Planar convex polygon with its corners counter-clockwise as seen from the front: a surface or a surface clipped by a
/// plane.
struct FlatPolygon
{
    std::array<Vec3, 5> corners; ///< only the first `size` are used
    std::size_t size = 0;

    bool empty() const { return size == 0; }
    void add(Vec3 corner) { corners[size++] = corner; }
    Vec3 next(std::size_t k) const { return corners[k + 1 < size ? k + 1 : 0]; } ///< the corner after corner k
};

/// Outline of a surface.
FlatPolygon polygon_of(const Surface& surface);

/// The three or four corners of the same polygon.
std::vector<Vec3> corners_of(const Surface& surface);

/// Smallest and largest signed distance of a polygon's corners from a plane [scene units].
struct HeightRange
{
    double low;
    double high;

    bool within(double limit) const { return low >= -limit && high <= limit; }
};
/// Heights of the corners above the plane through `point` with this unit normal.
HeightRange heights(const FlatPolygon& polygon, Vec3 point, Vec3 normal);

/// Clips a surface's polygon to the front side of a plane; corners at most `touching` behind the plane count as in
/// front. Empty if no more than an edge or a corner is left.
FlatPolygon part_in_front(const FlatPolygon& polygon, Vec3 point, Vec3 normal, double touching);

/// Orthogonal projection of the polygon onto the plane through `point` with this unit normal.
FlatPolygon projected(FlatPolygon polygon, Vec3 point, Vec3 normal);

/// The part of the surface in front of the plane through `point` with this unit normal, that is, above the horizon of a
/// receiver at `point`. Corners within rounding error of the plane count as in it. Empty if nothing rises above it.
FlatPolygon part_above_horizon(const Surface& surface, Vec3 point, Vec3 normal);

/// True if a point of the plane of a non-empty polygon lies inside the polygon or on its border.
bool contains(const FlatPolygon& polygon, Vec3 point);

/// Distance from the point to the nearest point of a non-empty polygon [scene units].
double distance(Vec3 point, const FlatPolygon& polygon);

/// Point-to-polygon form factor [1] by Lambert's formula: the irradiance at a point with this unit normal if the front
/// of the polygon has radiosity 1. The whole polygon must lie above the point's horizon. 0 if the point is behind the
/// polygon.
double irradiance_from(const FlatPolygon& polygon, Vec3 point, Vec3 normal);

/// Lambert's formula for any number of corners, not clamped to 0 ... 1: negative for a polygon seen from its back.
double lambert_sum(const Vec3* corners, std::size_t count, Vec3 point, Vec3 normal);

} // namespace multipath
