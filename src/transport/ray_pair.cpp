// Between points x, y that are uniform on their patches a ray weighs cos cos' / r^2. Where the patches come close this
// grows without bound and a few rays would decide everything. There the direction is drawn uniformly from the solid
// angle of the larger patch at x instead; then the weight is the solid angle times the cosine at x.

#include "transport/ray_pair.h"

#include "sampling/spherical_triangle.h"
#include "sampling/warp.h"

#include <algorithm>

namespace multipath {

namespace {

Vec3 point_at(const Surface& shape, double u, double v)
{
    if (shape.shape == Shape::parallelogram)
        return shape.at(u, v);
    const Barycentric place = square_to_uniform_triangle(u, v);
    return shape.at(place.u, place.v);
}

/// No point of the shape is farther from its centre.
double radius(const Surface& shape)
{
    return length(shape.edge_u) + length(shape.edge_v);
}

} // namespace

RayPair::RayPair(const Scene& scene, std::uint32_t one, std::uint32_t other)
{
    const bool one_is_smaller = scene.area(one) <= scene.area(other);
    const std::uint32_t from = one_is_smaller ? one : other;
    const std::uint32_t to = one_is_smaller ? other : one;
    from_ = scene.patch(from);
    to_ = scene.patch(to);
    from_normal_ = from_.shape.normal();
    to_normal_ = to_.shape.normal();
    to_front_ = dot(to_normal_, scene.surfaces()[to_.surface].normal()) > 0.0;
    near_ = length(to_.shape.centre() - from_.shape.centre()) < radius(from_.shape) + radius(to_.shape);
}

RayPair::Ray RayPair::ray(const Item& item) const
{
    const Vec3 start = point_at(from_.shape, item[0], item[1]);
    return near_ ? into_solid_angle(start, item[2], item[3]) : towards_point(start, item[2], item[3]);
}

RayPair::Ray RayPair::towards_point(Vec3 start, double u, double v) const
{
    const Vec3 d = point_at(to_.shape, u, v) - start;
    const double leaving = dot(from_normal_, d);
    const double arriving = -dot(to_normal_, d);
    if (leaving <= 0.0 || arriving <= 0.0)
        return {{start, d}, 0.0};
    const double square = dot(d, d);
    return {{start, d}, leaving * arriving / (square * square)};
}

RayPair::Ray RayPair::into_solid_angle(Vec3 start, double u, double v) const
{
    if (!(dot(to_normal_, start - to_.shape.origin) > 0.0))
        return {{start, to_normal_}, 0.0};
    const auto corner = [&](double a, double b) { return normalized(to_.shape.at(a, b) - start); };
    const SphericalTriangle first(corner(0, 0), corner(1, 0), corner(0, 1));
    const bool has_second = to_.shape.shape == Shape::parallelogram;
    const SphericalTriangle second = has_second ? SphericalTriangle(corner(1, 1), corner(0, 1), corner(1, 0)) : first;
    const double all = first.solid_angle() + (has_second ? second.solid_angle() : 0.0);
    if (!(all > 0.0))
        return {{start, to_normal_}, 0.0};
    const double split = first.solid_angle() / all;
    const Vec3 d = u < split ? first.direction(u / split, v) : second.direction((u - split) / (1.0 - split), v);
    return {{start, d}, all * std::max(0.0, dot(from_normal_, d))};
}

} // namespace multipath
