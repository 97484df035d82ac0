#include "geometry/surface_boxes.h"

#include "geometry/shared_planes.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

Bounds with_play(const Bounds& box, double play)
{
    const Vec3 margin = {play, play, play};
    return {box.low - margin, box.high + margin};
}

/// With a margin that exceeds the rounding errors of coordinates far from the origin.
Bounds widened(const Bounds& box)
{
    return with_play(box, 1e-12 * std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.low.z),
                                            std::abs(box.high.x), std::abs(box.high.y), std::abs(box.high.z)}));
}

} // namespace

Bounds bounds_of(const std::vector<Surface>& surfaces)
{
    Bounds box;
    for (const Surface& surface : surfaces)
        box.include(surface.bounds());
    return box;
}

Bounds box_around(const std::vector<Surface>& surfaces)
{
    const Bounds box = bounds_of(surfaces);
    return widened(with_play(box, 2.0 * coplanar_distance * box.diagonal()));
}

std::vector<Bounds> boxes_around_each(const std::vector<Surface>& surfaces)
{
    const double play = 2.0 * coplanar_distance * bounds_of(surfaces).diagonal();
    std::vector<Bounds> boxes;
    boxes.reserve(surfaces.size());
    for (const Surface& surface : surfaces)
        boxes.push_back(widened(with_play(surface.bounds(), play)));
    return boxes;
}

} // namespace multipath
