#include "transport/contact.h"

#include <optional>

namespace multipath {

namespace {

/// Is the point, known to lie in the plane of the shape, well inside it?
bool holds(const Surface& shape, Vec3 point)
{
    const Vec3 normal = cross(shape.edge_u, shape.edge_v);
    const double scale = 1.0 / dot(normal, normal);
    const Vec3 d = point - shape.origin;
    const double u = scale * dot(cross(d, shape.edge_v), normal);
    const double v = scale * dot(cross(shape.edge_u, d), normal);
    constexpr double inset = 1e-4;
    const bool in_triangle = shape.shape == Shape::parallelogram || u + v < 1.0 - inset;
    return u > inset && v > inset && u < 1.0 - inset && v < 1.0 - inset && in_triangle;
}

/// A point that both shapes hold, if one of a grid on the first is.
std::optional<Vec3> common_point(const Surface& small, const Surface& large, int grid)
{
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j) {
            const Vec3 point = small.at((i + 0.5) / grid, (j + 0.5) / grid);
            if (holds(small, point) && holds(large, point))
                return point;
        }
    return {};
}

} // namespace

bool in_contact(const Scene& scene, std::uint32_t one, std::uint32_t other)
{
    const bool one_is_small = scene.area(one) <= scene.area(other);
    const std::uint32_t from = one_is_small ? one : other;
    const std::uint32_t to = one_is_small ? other : one;
    const Patch start = scene.patch(from);
    const Surface end = scene.patch(to).shape;
    std::optional<Vec3> point = common_point(start.shape, end, 16);
    if (!point)
        point = common_point(start.shape, end, 128); // a sliver
    if (!point)
        return false;
    const std::optional<Hit> hit = scene.intersector().closest_hit_from(start.surface, {*point, start.shape.normal()});
    return hit && hit->surface == scene.surface_of(to) &&
           scene.patch_at(hit->surface, hit->u, hit->v, hit->front) == to;
}

} // namespace multipath
