#include "geometry/polygon_irradiance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace multipath {

ConvexPolygon outline(const Surface& surface)
{
    ConvexPolygon polygon;
    polygon.append(surface.origin);
    polygon.append(surface.origin + surface.edge_u);
    if (surface.shape == Shape::parallelogram)
        polygon.append(surface.at(1.0, 1.0));
    polygon.append(surface.origin + surface.edge_v);
    return polygon;
}

ConvexPolygon part_in_front(const Surface& surface, Vec3 point, Vec3 normal)
{
    const ConvexPolygon whole = outline(surface);
    const double play = 1e-10 * (length(surface.edge_u) + length(surface.edge_v) + length(surface.origin - point));
    std::array<double, 5> height{};
    bool any_in_front = false;
    for (std::size_t k = 0; k < whole.count; ++k) {
        height[k] = dot(normal, whole.corners[k] - point);
        if (std::abs(height[k]) <= play)
            height[k] = 0.0;
        any_in_front = any_in_front || height[k] > 0.0;
    }
    ConvexPolygon part;
    if (!any_in_front)
        return part;
    for (std::size_t k = 0; k < whole.count; ++k) {
        const double here = height[k];
        const double there = height[k + 1 < whole.count ? k + 1 : 0];
        if (here >= 0.0)
            part.append(whole.corners[k]);
        if ((here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0))
            part.append(whole.corners[k] + here / (here - there) * (whole.next(k) - whole.corners[k]));
    }
    return part;
}

namespace {

Vec3 upward(const ConvexPolygon& polygon)
{
    return cross(polygon.corners[1] - polygon.corners[0], polygon.corners[2] - polygon.corners[0]);
}

} // namespace

bool contains(const ConvexPolygon& polygon, Vec3 point)
{
    const Vec3 up = upward(polygon);
    for (std::size_t k = 0; k < polygon.count; ++k)
        if (dot(cross(up, polygon.next(k) - polygon.corners[k]), point - polygon.corners[k]) < 0.0)
            return false;
    return true;
}

double distance(Vec3 point, const ConvexPolygon& polygon)
{
    if (contains(polygon, point)) { // or above it, which the test does not tell apart
        const Vec3 up = upward(polygon);
        return std::abs(dot(up, point - polygon.corners[0])) / length(up);
    }
    double square = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < polygon.count; ++k) {
        const Vec3 edge = polygon.next(k) - polygon.corners[k];
        const Vec3 to_point = point - polygon.corners[k];
        const double along = std::clamp(dot(to_point, edge) / dot(edge, edge), 0.0, 1.0);
        const Vec3 from_edge = to_point - along * edge;
        square = std::min(square, dot(from_edge, from_edge));
    }
    return std::sqrt(square);
}

double irradiance_from(const ConvexPolygon& polygon, Vec3 point, Vec3 normal)
{
    // Each edge adds the angle under which it is seen times the cosine between the normal and the plane through edge
    // and point; clockwise as seen from the front, hence the sign.
    double sum = 0.0;
    for (std::size_t k = 0; k < polygon.count; ++k) {
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
