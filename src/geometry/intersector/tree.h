#pragma once

#include "geometry/bounds.h"
#include "geometry/conditions.h"
#include "geometry/intersector/filter_line.h"
#include "geometry/intersector/surface_block.h"
#include "parallel/memory.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Hierarchy of boxes around numbered things, 16 to a node, split by the surface area heuristic. Its leaves are blocks
/// of up to 16 things.
class WideTree
{
public:
    static constexpr std::uint32_t nothing = 0xffffffffu;

    WideTree() = default;
    /// A tree over the things `numbers`, whose boxes are boxes[number]; for less than 2^26 things.
    WideTree(const LargeVector<Bounds>& boxes, const std::vector<std::uint32_t>& numbers, const FilterFrame& frame);

    bool empty() const { return nodes_.empty(); }
    const WideNode* nodes() const { return nodes_.data(); }

    /// What lies in the lanes of the blocks, 16 to a block; `nothing` in empty lanes.
    const LargeVector<std::uint32_t>& things() const { return things_; }

    /// How many children a search may have put aside at a time, if it takes up the last one first.
    unsigned most_pending() const { return most_pending_; }

    /// Calls visit(number) for all things whose boxes hold the point, and for others, until it returns false.
    template <class Visit>
    void for_each_around(Vec3 point_in_frame, const Visit& visit) const
    {
        for_each_near({point_in_frame, point_in_frame}, visit);
    }
    /// The same for all things whose boxes meet a box.
    template <class Visit>
    void for_each_near(const Bounds& box_in_frame, const Visit& visit) const;

private:
    template <class Visit>
    bool visit_child(std::uint32_t child, const float (&low)[3], const float (&high)[3], const Visit& visit) const;

    LargeVector<WideNode> nodes_;
    LargeVector<std::uint32_t> things_;
    unsigned most_pending_ = 0;
};

template <class Visit>
void WideTree::for_each_near(const Bounds& box, const Visit& visit) const
{
    const auto single = [](double x) { return static_cast<float>(x); };
    if (!empty())
        visit_child(0, {single(box.low.x), single(box.low.y), single(box.low.z)},
                    {single(box.high.x), single(box.high.y), single(box.high.z)}, visit);
}

template <class Visit>
bool WideTree::visit_child(std::uint32_t child, const float (&low)[3], const float (&high)[3], const Visit& visit) const
{
    if ((child & WideNode::leaf_flag) != 0) {
        const std::size_t first = std::size_t{WideNode::lanes} * (child - WideNode::leaf_flag);
        for (std::size_t i = first; i < first + WideNode::lanes && things_[i] != nothing; ++i)
            if (!visit(things_[i]))
                return false;
        return true;
    }
    const WideNode& node = nodes_[child];
    for (unsigned lane = 0; lane < WideNode::lanes; ++lane) {
        bool meets = true;
        for (unsigned axis = 0; axis < 3; ++axis)
            meets = every(meets, node.plane[WideNode::low(axis) + lane] <= high[axis],
                          low[axis] <= node.plane[WideNode::high(axis) + lane]);
        if (meets && !visit_child(node.child[lane], low, high, visit))
            return false;
    }
    return true;
}

} // namespace multipath
