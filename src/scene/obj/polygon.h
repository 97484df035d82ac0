#pragma once

#include "geometry/vec3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// The area of a closed polygon times its unit normal (Newell's formula). Its corners run counter-clockwise seen from
/// the front.
Vec3 area_vector(const std::vector<Vec3>& corners);

/// The largest distance of a corner from the polygon's mean plane [scene units]; 0 for a planar polygon. The area
/// vector must not be zero.
double distance_from_plane(const std::vector<Vec3>& corners, Vec3 area_vector);

/// The number of reflex corners, which turn clockwise; 0 for a convex polygon.
std::size_t reflex_corner_count(const std::vector<Vec3>& corners, Vec3 area_vector);

/// Triangles given by indices of the polygon's corners, counter-clockwise like the polygon.
struct Triangulation
{
    std::vector<std::array<std::uint32_t, 3>> triangles;
    bool crosses_itself = false; ///< not a simple polygon: the triangles overlap
};

/// Triangulates a polygon whose area vector is not zero, by ear clipping. Seen along that vector, the triangles cover
/// the polygon once, unless it crosses itself. A corner counts as straight, and is dropped without a triangle, if the
/// triangle with its two neighbours has an area of at most `smallest_area` [scene units^2] when it is projected along
/// the axis of the largest component of the area vector. The time is proportional to corners x (1 + reflex corners).
Triangulation clip_ears(const std::vector<Vec3>& corners, Vec3 area_vector, double smallest_area);

} // namespace multipath
