#pragma once

#include "geometry/vec3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Area times unit normal of a closed polygon, by Newell's formula; corners counter-clockwise seen from the front.
Vec3 area_vector(const std::vector<Vec3>& corners);

/// Largest distance of a corner from the mean plane [scene units]; 0 for a planar polygon.
double distance_from_plane(const std::vector<Vec3>& corners, Vec3 area_vector);

/// How many corners turn clockwise; none in a convex polygon.
std::size_t reflex_corner_count(const std::vector<Vec3>& corners, Vec3 area_vector);

/// Triangles by corner numbers, counter-clockwise like the polygon.
struct Triangulation
{
    std::vector<std::array<std::uint32_t, 3>> triangles;
    bool crosses_itself = false; ///< not a simple polygon: the triangles overlap
};

/// Cuts a polygon (its area vector not zero) into triangles that cover it once, as seen along the area vector. Corners
/// whose triangle is not larger than `smallest_area` are taken for straight. Time grows like corners x reflex corners.
Triangulation clip_ears(const std::vector<Vec3>& corners, Vec3 area_vector, double smallest_area);

} // namespace multipath
