#include "geometry/surface_order.h"

#include "geometry/surface_boxes.h"

#include <algorithm>

namespace multipath {

std::vector<std::uint32_t> from_large_to_small(const std::vector<Surface>& surfaces)
{
    struct Entry
    {
        double area;
        std::uint32_t surface;
    };
    std::vector<Entry> entries;
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
    for (std::size_t place = 0; place < order.size(); ++place)
        rank[order[place]] = static_cast<std::uint32_t>(order.size() - 1 - place);
    return rank;
}

bool form_a_room(const std::vector<Surface>& surfaces)
{
    const Bounds box = box_around(surfaces);
    double volume = 0.0;
    for (const Surface& surface : surfaces)
        volume += surface.area() * dot(surface.normal(), surface.centre() - box.centre()) / 3.0;
    const double size = box.diagonal();
    return volume < -1e-9 * size * size * size;
}

} // namespace multipath
