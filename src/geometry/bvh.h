#pragma once

#include "geometry/bounds.h"
#include "geometry/line.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace multipath {

/// Binary bounding volume hierarchy over numbered boxes, split by the surface area heuristic.
/// Conservative: visits every box that the line meets, and others.
class Bvh
{
public:
    Bvh() = default;
    explicit Bvh(const std::vector<Bounds>& boxes);

    bool empty() const { return nodes_.empty(); }

    /// Calls visit(number) for the boxes that the line meets before t_limit(); the limit may fall while visiting.
    template <class Limit, class Visit>
    void for_each_met(const Line& line, const Limit& t_limit, const Visit& visit) const;

private:
    struct Node
    {
        Bounds box;
        std::uint32_t first = 0; ///< leaf: first entry of order_; inner: its two children stand at first, first + 1
        std::uint32_t count = 0; ///< leaf: number of entries; inner: 0
    };
    struct Builder;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_; ///< box numbers, leaf by leaf
};

/// The box with a margin that exceeds the rounding errors of clip_to_box, in proportion to how far from the origin it
/// lies.
Bounds widened(const Bounds& box);

/// Where the line is inside a box: entry and exit parameters; entry > exit means it misses.
struct Slab
{
    double entry;
    double exit;
};

inline Slab clip_to_box(const Bounds& box, Vec3 origin, Vec3 inverse_direction, double t_max)
{
    // A direction component of zero gives infinities, or NaN for an origin exactly on a border, which the widened boxes
    // keep away from anything that could be met.
    const auto along = [](Slab slab, double low, double high, double o, double inverse) {
        const double a = (low - o) * inverse;
        const double b = (high - o) * inverse;
        return Slab{std::max(slab.entry, std::min(a, b)), std::min(slab.exit, std::max(a, b))};
    };
    Slab slab{0.0, t_max};
    slab = along(slab, box.low.x, box.high.x, origin.x, inverse_direction.x);
    slab = along(slab, box.low.y, box.high.y, origin.y, inverse_direction.y);
    return along(slab, box.low.z, box.high.z, origin.z, inverse_direction.z);
}

template <class Limit, class Visit>
void Bvh::for_each_met(const Line& line, const Limit& t_limit, const Visit& visit) const
{
    if (nodes_.empty())
        return;
    const Vec3 inverse = {1.0 / line.direction.x, 1.0 / line.direction.y, 1.0 / line.direction.z};
    const auto entry_of = [&](std::uint32_t node) {
        const Slab slab = clip_to_box(nodes_[node].box, line.origin, inverse, std::min(line.t_max, t_limit()));
        return slab.entry <= slab.exit ? slab.entry : Bounds::infinity;
    };
    struct Pending
    {
        std::uint32_t node;
        double entry;
    };
    std::array<Pending, 64> stack; // the builder keeps the depth below 60
    std::size_t depth = 0;
    stack[depth++] = {0, entry_of(0)};
    while (depth > 0) {
        const Pending next = stack[--depth];
        if (next.entry == Bounds::infinity || next.entry > t_limit())
            continue;
        const Node& node = nodes_[next.node];
        for (std::uint32_t i = 0; i < node.count; ++i)
            visit(order_[node.first + i]);
        if (node.count > 0)
            continue;
        Pending near{node.first, entry_of(node.first)};
        Pending far{node.first + 1, entry_of(node.first + 1)};
        if (far.entry < near.entry)
            std::swap(near, far);
        stack[depth++] = far;
        stack[depth++] = near;
    }
}

} // namespace multipath
