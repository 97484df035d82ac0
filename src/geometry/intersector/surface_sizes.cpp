#include "geometry/intersector/surface_sizes.h"

#include "geometry/intersector/shared_planes.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

Bounds expanded(const Bounds& box, double margin)
{
    const Vec3 step = {margin, margin, margin};
    return {box.low - step, box.high + step};
}

/// The box with a margin above the rounding errors of coordinates far from the origin.
Bounds safe_from_rounding(const Bounds& box)
{
    return expanded(box, 1e-12 * std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.low.z),
                                           std::abs(box.high.x), std::abs(box.high.y), std::abs(box.high.z)}));
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
    return safe_from_rounding(expanded(box, 2.0 * coplanar_distance * box.diagonal()));
}

LargeVector<Bounds> boxes_around_each(const SurfaceList& surfaces)
{
    const double margin = 2.0 * coplanar_distance * bounds_of(surfaces).diagonal();
    LargeVector<Bounds> boxes;
    boxes.reserve(surfaces.size());
    for (const Surface& surface : surfaces)
        boxes.push_back(safe_from_rounding(expanded(surface.bounds(), margin)));
    return boxes;
}

std::vector<std::uint32_t> order_by_descending_area(const SurfaceList& surfaces)
{
    struct Entry
    {
        double area;
        std::uint32_t surface;
    };
    LargeVector<Entry> entries;
    entries.reserve(surfaces.size());
    for (const Surface& surface : surfaces)
        entries.push_back({surface.area(), static_cast<std::uint32_t>(entries.size())});
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return a.area > b.area || (a.area == b.area && a.surface < b.surface);
    });
    std::vector<std::uint32_t> order;
    order.reserve(surfaces.size());
    for (const Entry& entry : entries)
        order.push_back(entry.surface);
    return order;
}

std::vector<std::uint32_t> size_ranks(const std::vector<std::uint32_t>& order)
{
    std::vector<std::uint32_t> rank(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        rank[order[k]] = static_cast<std::uint32_t>(order.size() - 1 - k);
    return rank;
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
