#pragma once

#include "geometry/vec3.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Sides of surfaces in one plane and their bounding rectangle.
struct Chart
{
    std::vector<std::uint32_t> sides; ///< numbered as Lightmap::frames
    Vec3 corner;                      ///< lower left corner of the rectangle, seen from the front
    Vec3 along_x;                     ///< unit vector along the width
    Vec3 along_y;                     ///< unit vector along the height
    double width = 0.0;               ///< [scene units]
    double height = 0.0;              ///< [scene units]
};

/// Divides the surfaces of a scene, except the sky, into charts: starting with the largest surface, a flood fill over
/// shared edges collects coplanar surfaces of one material. The chart of the largest surface is the first. In a
/// two-sided scene, the charts of the backs follow in the same order, laid out like those of the fronts.
std::vector<Chart> charts_of(const Scene& scene);

} // namespace multipath
