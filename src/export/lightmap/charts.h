#pragma once

#include "geometry/vec3.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// The bounding rectangle of a side of a surface, in its plane.
struct Chart
{
    Vec3 corner;         ///< lower left corner of the rectangle, seen from the front
    Vec3 along_x;        ///< unit vector along the width
    Vec3 along_y;        ///< unit vector along the height
    double width = 0.0;  ///< [scene units] not less than the height
    double height = 0.0; ///< [scene units]
};

/// The charts of all sides of a scene's surfaces, except the sky, numbered as Lightmap::frames. The width of a chart is
/// along the longest edge of the surface.
std::vector<Chart> charts_of(const Scene& scene);

} // namespace multipath
