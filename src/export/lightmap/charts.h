#pragma once

#include "geometry/vec3.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Surfaces in one plane and their bounding rectangle.
struct Chart
{
    std::size_t first = 0; ///< index in ChartList::surfaces
    std::size_t count = 0;
    Vec3 corner;         ///< lower left corner of the rectangle, seen from the front
    Vec3 along_x;        ///< unit vector along the width
    Vec3 along_y;        ///< unit vector along the height
    double width = 0.0;  ///< [scene units]
    double height = 0.0; ///< [scene units]
};

struct ChartList
{
    std::vector<Chart> charts;
    std::vector<std::uint32_t> surfaces; ///< of all charts, one chart after the other
};

/// Divides the surfaces of a scene, except the sky, into charts: starting with the largest surface, a flood fill over
/// shared edges collects coplanar surfaces of one material. The chart of the largest surface is the first.
ChartList charts_of(const Scene& scene);

} // namespace multipath
