#include "transport/exchange/contact.h"

#include "geometry/intersector/intersector.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace multipath {

namespace {

/// Coordinates in the plane of a shape: those of its surface, with (0, 0) at its origin and 1 at the end of each edge.
class EdgeCoordinates
{
public:
    explicit EdgeCoordinates(const Surface& shape)
        : shape_(shape), normal_(cross(shape.edge_u, shape.edge_v)), scale_(1.0 / dot(normal_, normal_))
    {
    }

    double u(Vec3 from_origin) const { return scale_ * dot(cross(from_origin, shape_.edge_v), normal_); }
    double v(Vec3 from_origin) const { return scale_ * dot(cross(shape_.edge_u, from_origin), normal_); }

    /// True if a point of the plane of the shape lies inside it, clear of its border.
    bool contains(Vec3 point) const
    {
        const double at_u = u(point - shape_.origin);
        const double at_v = v(point - shape_.origin);
        const bool in_triangle = shape_.shape == Shape::parallelogram || at_u + at_v < 1.0 - inset;
        return at_u > inset && at_v > inset && at_u < 1.0 - inset && at_v < 1.0 - inset && in_triangle;
    }

    /// The range {first, last} of k in 0 ... count - 1 that contains all points start + k step inside the shape, to be
    /// tested by contains(); last < first if there are none.
    std::pair<int, int> range_inside(Vec3 start, Vec3 step, int count) const
    {
        const double at_u = u(start - shape_.origin);
        const double at_v = v(start - shape_.origin);
        const double step_u = u(step);
        const double step_v = v(step);
        double first = 0.0;
        double last = count - 1.0;
        const auto require_positive = [&](double at, double slope) { // at + k slope > 0
            if (slope > 0.0)
                first = std::max(first, -at / slope);
            else if (slope < 0.0)
                last = std::min(last, -at / slope);
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
    static constexpr double inset = 1e-4; ///< share of an edge

    Surface shape_;
    Vec3 normal_;
    double scale_;
};

/// A point inside both shapes, if one of the grid x grid points on the first one is inside the second.
std::optional<Vec3> common_point(const Surface& small, const Surface& large, int grid)
{
    const EdgeCoordinates on_small(small);
    const EdgeCoordinates on_large(large);
    for (int i = 0; i < grid; ++i) {
        const auto point = [&](int j) { return small.at((i + 0.5) / grid, (j + 0.5) / grid); };
        const auto [first, last] = on_large.range_inside(point(0), (1.0 / grid) * small.edge_v, grid);
        for (int j = first; j <= last; ++j)
            if (on_small.contains(point(j)) && on_large.contains(point(j)))
                return point(j);
    }
    return {};
}

} // namespace

bool in_contact(const Scene& scene, std::uint32_t a, std::uint32_t b)
{
    const bool a_is_small = scene.area(a) <= scene.area(b);
    const std::uint32_t from = a_is_small ? a : b;
    const std::uint32_t to = a_is_small ? b : a;
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
