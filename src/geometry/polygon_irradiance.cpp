#include "geometry/polygon_irradiance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace multipath {

FlatPolygon part_above_horizon(const Surface& surface, Vec3 point, Vec3 normal)
{
    const FlatPolygon whole = polygon_of(surface);
    const double play = 1e-10 * (length(surface.edge_u) + length(surface.edge_v) + length(surface.origin - point));
    return heights(whole, point, normal).high > play ? part_in_front(whole, point, normal, play) : FlatPolygon{};
}

namespace {

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
    if (contains(polygon, point)) { // or above it, which the test does not tell apart
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
    // Each edge adds the angle under which it is seen times the cosine between the normal and the normal of the plane
    // through edge and point. Edges run counter-clockwise as seen from the point, so that the cross products of their
    // ends point away from the polygon: hence the sign.
    double sum = 0.0;
    for (std::size_t k = 0; k < polygon.size; ++k) {
        const Vec3 a = polygon.corners[k] - point;
        const Vec3 b = polygon.next(k) - point;
        const Vec3 across = cross(a, b);
        const double sine = length(across);
        if (sine > 0.0)
            sum -= std::atan2(sine, dot(a, b)) / sine * dot(normal, across);
    }
    constexpr double two_pi = 6.28318530717958647692;
    return std::clamp(sum / two_pi, 0.0, 1.0);
}

} // namespace multipath
