#include "transport/exchange/contact.h"

#include "geometry/intersector/intersector.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace multipath {

namespace {

/// Coordinates in the plane of a shape, along its edges.
class EdgeCoordinates
{
public:
    explicit EdgeCoordinates(const Surface& shape)
        : shape_(shape), normal_(cross(shape.edge_u, shape.edge_v)), scale_(1.0 / dot(normal_, normal_))
    {
    }

    double u(Vec3 from_origin) const { return scale_ * dot(cross(from_origin, shape_.edge_v), normal_); }
    double v(Vec3 from_origin) const { return scale_ * dot(cross(shape_.edge_u, from_origin), normal_); }

    /// Is the point, known to lie in the plane of the shape, well inside it?
    bool holds(Vec3 point) const
    {
        const double at_u = u(point - shape_.origin);
        const double at_v = v(point - shape_.origin);
        const bool in_triangle = shape_.shape == Shape::parallelogram || at_u + at_v < 1.0 - inset;
        return at_u > inset && at_v > inset && at_u < 1.0 - inset && at_v < 1.0 - inset && in_triangle;
    }

    /// The part of start + k step (k = 0 ... count - 1) that may be well inside: first ... last, which may be none.
    std::pair<int, int> part_inside(Vec3 start, Vec3 step, int count) const
    {
        const double at_u = u(start - shape_.origin);
        const double at_v = v(start - shape_.origin);
        const double step_u = u(step);
        const double step_v = v(step);
        double first = 0.0;
        double last = count - 1.0;
        const auto require_positive = [&](double at, double climb) {
            if (climb > 0.0)
                first = std::max(first, -at / climb);
            else if (climb < 0.0)
                last = std::min(last, -at / climb);
            else if (!(at > 0.0))
                last = -1.0;
        };
        require_positive(at_u, step_u);
        require_positive(at_v, step_v);
        require_positive(1.0 - at_u, -step_u);
        require_positive(1.0 - at_v, -step_v);
        if (shape_.shape == Shape::triangle)
            require_positive(1.0 - at_u - at_v, -step_u - step_v);
        return first <= last ? std::pair<int, int>{static_cast<int>(first), static_cast<int>(std::ceil(last))}
                             : std::pair<int, int>{0, -1};
    }

private:
    static constexpr double inset = 1e-4;

    Surface shape_;
    Vec3 normal_;
    double scale_;
};

/// A point that both shapes hold, if one of a grid on the first is.
std::optional<Vec3> common_point(const Surface& small, const Surface& large, int grid)
{
    const EdgeCoordinates on_small(small);
    const EdgeCoordinates on_large(large);
    for (int i = 0; i < grid; ++i) {
        const auto place = [&](int j) { return small.at((i + 0.5) / grid, (j + 0.5) / grid); };
        const auto [first, last] = on_large.part_inside(place(0), (1.0 / grid) * small.edge_v, grid);
        for (int j = first; j <= last; ++j)
            if (on_small.holds(place(j)) && on_large.holds(place(j)))
                return place(j);
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
