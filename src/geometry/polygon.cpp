// Polygons are clipped by one plane at a time (Sutherland and Hodgman 1974). Lambert's formula gives the irradiance
// from a polygon as a sum over its edges.

#include "geometry/polygon.h"

#include "base/elementary.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
        // An edge that dips below the plane by no more than `touching` is not cut.
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

FlatPolygon part_above_horizon(const Surface& surface, Vec3 point, Vec3 normal)
{
    const FlatPolygon whole = polygon_of(surface);
    const double slack = 1e-10 * (length(surface.edge_u) + length(surface.edge_v) + length(surface.origin - point));
    return heights(whole, point, normal).high > slack ? part_in_front(whole, point, normal, slack) : FlatPolygon{};
}

namespace {

/// A normal of the polygon, not of unit length.
Vec3 upward(const FlatPolygon& polygon)
{
    return cross(polygon.corners[1] - polygon.corners[0], polygon.corners[2] - polygon.corners[0]);
}

} // namespace

bool contains(const FlatPolygon& polygon, Vec3 point)
{
    const Vec3 up = upward(polygon);
    for (std::size_t k = 0; k < polygon.size; ++k)
        if (dot(cross(up, polygon.next(k) - polygon.corners[k]), point - polygon.corners[k]) < 0.0)
            return false;
    return true;
}

double distance(Vec3 point, const FlatPolygon& polygon)
{
    if (contains(polygon, point)) { // or the projection of the point onto its plane
        const Vec3 up = upward(polygon);
        return std::abs(dot(up, point - polygon.corners[0])) / length(up);
    }
    double square = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < polygon.size; ++k) {
        const Vec3 edge = polygon.next(k) - polygon.corners[k];
        const Vec3 to_point = point - polygon.corners[k];
        const double along = std::clamp(dot(to_point, edge) / dot(edge, edge), 0.0, 1.0);
        const Vec3 from_edge = to_point - along * edge;
        square = std::min(square, dot(from_edge, from_edge));
    }
    return std::sqrt(square);
}

double irradiance_from(const FlatPolygon& polygon, Vec3 point, Vec3 normal)
{
    // Each edge contributes the angle that it subtends times the cosine between `normal` and the normal of the plane
    // through the edge and the point. The edges run counter-clockwise as seen from the front, so the cross product of
    // the ends of an edge points away from the polygon: hence the minus sign.
    double sum = 0.0;
    for (std::size_t k = 0; k < polygon.size; ++k) {
        const Vec3 a = polygon.corners[k] - point;
        const Vec3 b = polygon.next(k) - point;
        const Vec3 across = cross(a, b);
        const double sine = length(across);
        if (sine > 0.0)
            sum -= elementary::atan2(sine, dot(a, b)) / sine * dot(normal, across);
    }
    return std::clamp(sum / (2.0 * pi), 0.0, 1.0);
}

} // namespace multipath
