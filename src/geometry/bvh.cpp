#include "geometry/bvh.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace multipath {

namespace {

constexpr std::uint32_t leaf_size = 4;
constexpr int bins = 16;
constexpr int depth_limit = 56; // beyond it halves are cut by count, which ends within the traversal's stack

double component(Vec3 v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

struct Split
{
    int axis = -1; ///< -1: no split separates the boxes
    int last_left_bin = 0;
};

} // namespace

Bounds widened(const Bounds& box)
{
    const Vec3 low = box.low;
    const Vec3 high = box.high;
    const double reach = std::max(
        {std::abs(low.x), std::abs(low.y), std::abs(low.z), std::abs(high.x), std::abs(high.y), std::abs(high.z)});
    const Vec3 margin = {1e-12 * reach, 1e-12 * reach, 1e-12 * reach};
    return {low - margin, high + margin};
}

struct Bvh::Builder
{
    const std::vector<Bounds>& boxes;
    std::vector<Vec3> centres;
    Bvh& bvh;

    int bin_of(std::uint32_t number, int axis, const Bounds& range) const
    {
        const double low = component(range.low, axis);
        const double width = component(range.high, axis) - low;
        const double place = (component(centres[number], axis) - low) / width * bins;
        return std::min(static_cast<int>(place), bins - 1);
    }

    /// The cheapest cut between bins over the three axes by the surface area heuristic.
    Split best_split(std::uint32_t first, std::uint32_t last, const Bounds& range) const
    {
        Split best;
        double best_cost = Bounds::infinity;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(component(range.high, axis) > component(range.low, axis)))
                continue;
            std::array<Bounds, bins> box;
            std::array<std::uint32_t, bins> count{};
            for (std::uint32_t i = first; i < last; ++i) {
                const auto bin = static_cast<std::size_t>(bin_of(bvh.order_[i], axis, range));
                box[bin].include(boxes[bvh.order_[i]]);
                ++count[bin];
            }
            std::array<double, bins> left_cost{};
            Bounds left;
            std::uint32_t left_count = 0;
            for (std::size_t b = 0; b + 1 < bins; ++b) {
                if (count[b] > 0)
                    left.include(box[b]);
                left_count += count[b];
                left_cost[b] = left_count == 0 ? 0.0 : left_count * left.area();
            }
            Bounds right;
            std::uint32_t right_count = 0;
            for (std::size_t b = bins - 1; b > 0; --b) {
                if (count[b] > 0)
                    right.include(box[b]);
                right_count += count[b];
                const double cost = left_cost[b - 1] + (right_count == 0 ? 0.0 : right_count * right.area());
                if (right_count > 0 && right_count < last - first && cost < best_cost) {
                    best_cost = cost;
                    best = {axis, static_cast<int>(b) - 1};
                }
            }
        }
        return best;
    }

    void build(std::uint32_t node, std::uint32_t first, std::uint32_t last, int depth)
    {
        Bounds box;
        Bounds range;
        for (std::uint32_t i = first; i < last; ++i) {
            box.include(boxes[bvh.order_[i]]);
            range.include(centres[bvh.order_[i]]);
        }
        bvh.nodes_[node].box = widened(box);
        if (last - first <= leaf_size) {
            bvh.nodes_[node].first = first;
            bvh.nodes_[node].count = last - first;
            return;
        }
        const Split split = depth < depth_limit - 32 ? best_split(first, last, range) : Split{};
        const auto begin = bvh.order_.begin();
        std::uint32_t middle = first + (last - first) / 2;
        if (split.axis >= 0)
            middle = static_cast<std::uint32_t>(
                std::partition(begin + first, begin + last,
                               [&](std::uint32_t n) { return bin_of(n, split.axis, range) <= split.last_left_bin; }) -
                begin);
        const auto children = static_cast<std::uint32_t>(bvh.nodes_.size());
        bvh.nodes_[node].first = children;
        bvh.nodes_.resize(children + 2);
        build(children, first, middle, depth + 1);
        build(children + 1, middle, last, depth + 1);
    }
};

Bvh::Bvh(const std::vector<Bounds>& boxes)
{
    if (boxes.empty())
        return;
    order_.resize(boxes.size());
    std::iota(order_.begin(), order_.end(), 0u);
    Builder builder{boxes, {}, *this};
    builder.centres.reserve(boxes.size());
    for (const Bounds& box : boxes)
        builder.centres.push_back(box.centre());
    nodes_.resize(1);
    builder.build(0, 0, static_cast<std::uint32_t>(boxes.size()), 0);
}

} // namespace multipath
