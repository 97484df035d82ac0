#include "export/lightmap/charts.h"

#include "geometry/bounds.h"
#include "geometry/polygon.h"

#include <cstdint>

namespace multipath {

namespace {

Chart chart_of(const Surface& surface)
{
    Vec3 longest = surface.edge_u;
    if (length(surface.edge_v) > length(longest))
        longest = surface.edge_v;
    if (surface.shape == Shape::triangle && length(surface.edge_v - surface.edge_u) > length(longest))
        longest = surface.edge_v - surface.edge_u;
    const Vec3 along_x = normalized(longest);
    const Vec3 along_y = normalized(cross(surface.normal(), along_x));

    Bounds box; // in chart coordinates
    for (const Vec3 corner : corners_of(surface)) {
        const Vec3 p = corner - surface.origin;
        box.include(Vec3{dot(p, along_x), dot(p, along_y), 0.0});
    }
    const Vec3 corner = surface.origin + box.low.x * along_x + box.low.y * along_y;
    return {corner, along_x, along_y, box.size().x, box.size().y};
}

} // namespace

std::vector<Chart> charts_of(const Scene& scene)
{
    std::vector<Chart> charts;
    for (int side = 0; side < (scene.two_sided() ? 2 : 1); ++side)
        for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s)
            charts.push_back(chart_of(scene.surfaces()[s]));
    return charts;
}

} // namespace multipath
