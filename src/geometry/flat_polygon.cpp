#include "geometry/flat_polygon.h"

#include <algorithm>

namespace multipath {

FlatPolygon polygon_of(const Surface& surface)
{
    FlatPolygon result;
    result.add(surface.origin);
    result.add(surface.origin + surface.edge_u);
    if (surface.shape == Shape::parallelogram)
        result.add(surface.at(1.0, 1.0));
    result.add(surface.origin + surface.edge_v);
    return result;
}

std::vector<Vec3> corners_of(const Surface& surface)
{
    const FlatPolygon polygon = polygon_of(surface);
    return {polygon.corners.begin(), polygon.corners.begin() + static_cast<std::ptrdiff_t>(polygon.size)};
}

HeightRange heights(const FlatPolygon& polygon, Vec3 point, Vec3 normal)
{
    const double first = dot(polygon.corners[0] - point, normal);
    HeightRange range = {first, first};
    for (std::size_t k = 1; k < polygon.size; ++k) {
        const double height = dot(polygon.corners[k] - point, normal);
        range = {std::min(range.low, height), std::max(range.high, height)};
    }
    return range;
}

FlatPolygon part_in_front(const FlatPolygon& polygon, Vec3 point, Vec3 normal, double touching)
{
    FlatPolygon part;
    for (std::size_t k = 0; k < polygon.size; ++k) {
        const Vec3 from = polygon.corners[k];
        const Vec3 to = polygon.next(k);
        const double here = dot(from - point, normal);
        const double there = dot(to - point, normal);
        if (here >= -touching)
            part.add(from);
        // An edge that only dips below the plane by less than `touching` is not cut.
        if ((here > touching && there < -touching) || (here < -touching && there > touching))
            part.add(from + (here / (here - there)) * (to - from));
    }
    return part.size < 3 ? FlatPolygon{} : part;
}

FlatPolygon projected(FlatPolygon polygon, Vec3 point, Vec3 normal)
{
    for (std::size_t k = 0; k < polygon.size; ++k)
        polygon.corners[k] = polygon.corners[k] - dot(polygon.corners[k] - point, normal) * normal;
    return polygon;
}

} // namespace multipath
