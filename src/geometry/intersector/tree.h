#pragma once

#include "base/memory.h"
#include "geometry/bounds.h"
#include "geometry/intersector/line_batch.h"
#include "geometry/intersector/surface_block.h"

#include <array>
#include <cstdint>
#include <vector>

namespace multipath {

/// Bounding volume hierarchy over primitives (here: surfaces, given by their indices) with up to 16 children per node
/// and up to 16 primitives per leaf, built with the surface area heuristic.
class WideTree
{
public:
    static constexpr std::uint32_t nothing = 0xffffffffu; ///< an empty lane of a leaf

    WideTree() = default;
    /// Builds a tree over the primitives with these numbers. There must be fewer than 2^26 of them. The bounds of a
    /// primitive are boxes[number], in the coordinates of the scene. The boxes in the nodes are in the coordinates of
    /// the frame.
    WideTree(const LargeVector<Bounds>& boxes, const std::vector<std::uint32_t>& numbers, const FilterFrame& frame);

    bool empty() const { return nodes_.empty(); }
    /// The nodes; the root is the first.
    const WideNode* nodes() const { return nodes_.data(); }

    /// The primitives in the lanes of the leaves: leaf l has the elements 16 l ... 16 l + 15, with `nothing` in empty
    /// lanes.
    const LargeVector<std::uint32_t>& primitives() const { return primitives_; }

    /// Largest number of children that the stack of a depth-first search can hold at a time.
    unsigned most_pending() const { return most_pending_; }

    /// Calls visit(number) for all primitives whose boxes overlap `box_in_frame`, which is first rounded to single
    /// precision, and perhaps for more, until visit returns false.
    template <class Visit>
    void for_each_near(const Bounds& box_in_frame, const Visit& visit) const;

private:
    LargeVector<WideNode> nodes_;
    LargeVector<std::uint32_t> primitives_;
    unsigned most_pending_ = 0;
};

template <class Visit>
void WideTree::for_each_near(const Bounds& box, const Visit& visit) const
{
    const auto single = [](Vec3 p) {
        return std::array<float, 3>{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    };
    const std::array<float, 3> low = single(box.low);
    const std::array<float, 3> high = single(box.high);
    std::vector<std::uint32_t> pending; // children as in WideNode::child, at first the root
    pending.reserve(most_pending_ + 1);
    pending.resize(empty() ? 0 : 1);
    while (!pending.empty()) {
        const std::uint32_t child = pending.back();
        pending.pop_back();
        if ((child & WideNode::leaf_flag) != 0) {
            const std::size_t first = std::size_t{WideNode::lanes} * (child - WideNode::leaf_flag);
            for (std::size_t i = first; i < first + WideNode::lanes && primitives_[i] != nothing; ++i)
                if (!visit(primitives_[i]))
                    return;
            continue;
        }
        const WideNode& node = nodes_[child];
        std::array<std::uint32_t, WideNode::lanes> meets;
        for (unsigned lane = 0; lane < WideNode::lanes; ++lane) { // all first: such a loop is vectorised
            meets[lane] = 1;
            for (unsigned axis = 0; axis < 3; ++axis) {
                meets[lane] &= node.plane[WideNode::low(axis) + lane] <= high[axis] ? 1u : 0u;
                meets[lane] &= low[axis] <= node.plane[WideNode::high(axis) + lane] ? 1u : 0u;
            }
        }
        for (unsigned lane = 0; lane < WideNode::lanes; ++lane)
            if (meets[lane] != 0)
                pending.push_back(node.child[lane]);
    }
}

} // namespace multipath
