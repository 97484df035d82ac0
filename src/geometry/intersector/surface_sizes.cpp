#include "geometry/intersector/surface_sizes.h"

#include "base/lists.h"
#include "geometry/intersector/shared_planes.h"

#include <algorithm>
#include <utility>

namespace multipath {

namespace {

Bounds expanded(const Bounds& box, double margin)
{
    const Vec3 step = {margin, margin, margin};
    return {box.low - step, box.high + step};
}

/// The box with a margin and one above the rounding errors of coordinates far from the origin.
Bounds with_margin(const Bounds& box, double margin)
{
    const Bounds wider = expanded(box, margin);
    return expanded(wider, 1e-12 * wider.largest_coordinate());
}

} // namespace

Bounds bounds_of(const SurfaceList& surfaces)
{
    Bounds box;
    for (const Surface& surface : surfaces)
        box.include(surface.bounds());
    return box;
}

Bounds box_around(const SurfaceList& surfaces)
{
    const Bounds box = bounds_of(surfaces);
    return with_margin(box, 2.0 * coplanar_distance * box.diagonal());
}

LargeVector<Bounds> boxes_around_each(const SurfaceList& surfaces)
{
    const double margin = 2.0 * coplanar_distance * bounds_of(surfaces).diagonal();
    LargeVector<Bounds> boxes;
    boxes.reserve(surfaces.size());
    for (const Surface& surface : surfaces)
        boxes.push_back(with_margin(surface.bounds(), margin));
    return boxes;
}

std::vector<std::uint32_t> order_by_descending_area(const SurfaceList& surfaces)
{
    LargeVector<std::pair<double, std::uint32_t>> by_area; // descending: negated
    by_area.reserve(surfaces.size());
    for (const Surface& surface : surfaces)
        by_area.emplace_back(-surface.area(), static_cast<std::uint32_t>(by_area.size()));
    std::sort(by_area.begin(), by_area.end());
    return mapped(by_area, &std::pair<double, std::uint32_t>::second);
}

bool is_interior(const SurfaceList& surfaces)
{
    const Bounds box = box_around(surfaces);
    double volume = 0.0;
    for (const Surface& surface : surfaces)
        volume += surface.area() * dot(surface.normal(), surface.centre() - box.centre()) / 3.0;
    const double size = box.diagonal();
    return volume < -1e-9 * size * size * size;
}

} // namespace multipath
