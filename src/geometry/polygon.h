#pragma once

#include "geometry/surface.h"

#include <array>
#include <cstddef>
#include <vector>

namespace multipath {

/// Planar convex polygon: the outline of a surface, or of the part of a surface in front of a plane. The corners are in
/// counter-clockwise order as seen from the front. A polygon without corners is empty.
struct FlatPolygon
{
    std::array<Vec3, 5> corners; ///< only the first `size` are used; five are enough for a parallelogram cut once
    std::size_t size = 0;

    bool empty() const { return size == 0; }
    void add(Vec3 corner) { corners[size++] = corner; }
    Vec3 next(std::size_t k) const { return corners[k + 1 < size ? k + 1 : 0]; } ///< the corner after corner k
};

/// Outline of a surface: its three or four corners, beginning with the origin and the end of edge_u.
FlatPolygon polygon_of(const Surface& surface);

/// The corners of polygon_of(surface), in the same order.
std::vector<Vec3> corners_of(const Surface& surface);

/// Smallest and largest signed distance of the corners of a polygon from a plane [scene units], positive in front.
struct HeightRange
{
    double low;
    double high;

    /// True if no corner is farther than `limit` from the plane.
    bool within(double limit) const { return low >= -limit && high <= limit; }
};
/// Heights of the corners of a non-empty polygon above the plane through `point` with this normal, times the length of
/// the normal.
HeightRange heights(const FlatPolygon& polygon, Vec3 point, Vec3 normal);

/// Clips a polygon of at most four corners to the front side of the plane through `point` with this unit normal.
/// Corners at most `touching` [scene units] behind the plane are kept, so a polygon in the plane stays whole. The
/// result is empty if no more than an edge or a corner is left.
FlatPolygon part_in_front(const FlatPolygon& polygon, Vec3 point, Vec3 normal, double touching);

/// Orthogonal projection of the polygon onto the plane through `point` with this unit normal.
FlatPolygon projected(FlatPolygon polygon, Vec3 point, Vec3 normal);

/// The part of the surface in front of the plane through `point` with this unit normal, that is, above the horizon of a
/// receiver at `point`. Corners within rounding error of the plane count as in the plane. The result is empty if no
/// corner rises above the plane.
FlatPolygon part_above_horizon(const Surface& surface, Vec3 point, Vec3 normal);

/// True if the orthogonal projection of the point onto the plane of a non-empty polygon lies inside the polygon or on
/// its border. There is no tolerance for rounding.
bool contains(const FlatPolygon& polygon, Vec3 point);

/// Distance from the point to the nearest point of a non-empty polygon [scene units].
double distance(Vec3 point, const FlatPolygon& polygon);

/// Point-to-polygon form factor [1] by Lambert's formula: the irradiance of a small face at `point` with this unit
/// normal if the front of the polygon has radiosity 1. The whole polygon must lie in front of the face (see
/// part_above_horizon). Returns 0 if the point is behind the polygon; the result is clamped to 0 ... 1.
double irradiance_from(const FlatPolygon& polygon, Vec3 point, Vec3 normal);

} // namespace multipath
