// Bounding volume hierarchy with 16 children per node (Wald, Benthin, Boulos 2008), built top-down. Parts are split in
// two by the surface area heuristic (Goldsmith and Salmon 1987) over 16 bins along each axis (Wald 2007).

#include "geometry/intersector/tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace multipath {

namespace {

/// Box in single precision. The fourth components are padding, so that a compiler can use vectors of four.
struct SplitBox
{
    float low[4];
    float high[4];

    static SplitBox nothing()
    {
        constexpr float most = std::numeric_limits<float>::max();
        return {{most, most, most, most}, {-most, -most, -most, -most}};
    }

    void include(const SplitBox& other)
    {
        for (int i = 0; i < 4; ++i)
            low[i] = other.low[i] < low[i] ? other.low[i] : low[i];
        for (int i = 0; i < 4; ++i)
            high[i] = other.high[i] > high[i] ? other.high[i] : high[i];
    }
    float area() const
    {
        const float x = high[0] - low[0];
        const float y = high[1] - low[1];
        const float z = high[2] - low[2];
        return 2.0f * (x * y + y * z + z * x);
    }
};

/// A primitive while the tree is built.
struct SplitPrimitive
{
    SplitBox box;
    std::uint32_t number;
};

constexpr int bins = 16;

/// Box and number of the primitives in one bin or several.
struct Bin
{
    SplitBox box = SplitBox::nothing();
    std::uint32_t count = 0;

    void include(const Bin& other)
    {
        box.include(other.box);
        count += other.count;
    }
    /// Surface area times number of leaves, because a leaf costs the same however many of its lanes are used.
    float cost() const
    {
        const std::uint32_t leaves = (count + WideNode::lanes - 1) / WideNode::lanes;
        return leaves == 0 ? 0.0f : static_cast<float>(leaves) * box.area();
    }
};

/// Partitions the primitives first ... last - 1 at the cheapest border of bins along any axis, or into halves if no
/// border separates them. Returns the beginning of the second part; neither part is empty.
std::uint32_t split_by_area(LargeVector<SplitPrimitive>& primitives, std::uint32_t first, std::uint32_t last)
{
    SplitBox centres = SplitBox::nothing(); // all coordinates of centres are doubled
    for (std::uint32_t t = first; t < last; ++t) {
        const SplitBox& box = primitives[t].box;
        SplitBox centre;
        for (int i = 0; i < 4; ++i)
            centre.low[i] = centre.high[i] = box.low[i] + box.high[i];
        centres.include(centre);
    }
    float scale[3]; // bins per length; 0 along an axis where all centres are equal
    for (int axis = 0; axis < 3; ++axis) {
        const float exact = static_cast<float>(bins) / (centres.high[axis] - centres.low[axis]);
        scale[axis] = exact < std::numeric_limits<float>::max() ? exact : 0.0f;
    }
    const auto bin_of = [&](const SplitBox& box, int axis) {
        const float position = (box.low[axis] + box.high[axis] - centres.low[axis]) * scale[axis];
        return std::min(static_cast<int>(position), bins - 1);
    };
    Bin along[3][bins];
    for (std::uint32_t t = first; t < last; ++t)
        for (int axis = 0; axis < 3; ++axis) {
            Bin& bin = along[axis][bin_of(primitives[t].box, axis)];
            bin.box.include(primitives[t].box);
            ++bin.count;
        }
    int best_axis = 0;
    int second_part = 0; // its first bin
    float best_cost = std::numeric_limits<float>::max();
    for (int axis = 0; axis < 3; ++axis) {
        float left_cost[bins];
        Bin left;
        for (int b = 0; b < bins; ++b) {
            left.include(along[axis][b]);
            left_cost[b] = left.cost();
        }
        Bin right;
        for (int b = bins - 1; b > 0; --b) {
            right.include(along[axis][b]);
            const float cost = left_cost[b - 1] + right.cost();
            if (right.count > 0 && right.count < last - first && cost < best_cost) {
                best_axis = axis;
                second_part = b;
                best_cost = cost;
            }
        }
    }
    const auto begin = primitives.begin();
    const auto middle = std::partition(begin + first, begin + last, [&](const SplitPrimitive& primitive) {
        return bin_of(primitive.box, best_axis) < second_part;
    });
    return second_part > 0 ? static_cast<std::uint32_t>(middle - begin) : first + (last - first) / 2;
}

/// The largest float that is not above x.
float float_below(double x)
{
    const float nearest = static_cast<float>(x);
    return nearest <= x ? nearest : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

/// The box in the frame with a margin for the filters' rounding errors: see block_filling.cpp.
SplitBox in_frame(const Bounds& box, const FilterFrame& frame)
{
    constexpr double margin = 2e-6;
    const Vec3 low = frame.to_frame(box.low);
    const Vec3 high = frame.to_frame(box.high);
    return {{float_below(low.x - margin), float_below(low.y - margin), float_below(low.z - margin), 0.0f},
            {-float_below(-high.x - margin), -float_below(-high.y - margin), -float_below(-high.z - margin), 0.0f}};
}

/// Node with empty lanes only.
WideNode empty_node()
{
    WideNode node{};
    for (unsigned axis = 0; axis < 3; ++axis) {
        std::fill_n(node.plane + WideNode::low(axis), WideNode::lanes, std::numeric_limits<float>::max());
        std::fill_n(node.plane + WideNode::high(axis), WideNode::lanes, std::numeric_limits<float>::lowest());
    }
    return node;
}

/// A part of the primitives, which becomes a node or a leaf.
struct Part
{
    SplitBox box;
    std::uint32_t first; ///< its primitives are first ... last - 1 in the list
    std::uint32_t last;
    int level; ///< number of splits that made it

    bool is_leaf() const { return last - first <= WideNode::lanes; }
};

constexpr int levels_by_area = 38; ///< then halves: at most 64 levels of fewer than 2^26 primitives

/// Builds the hierarchy from the primitives, which it reorders.
struct Builder
{
    LargeVector<SplitPrimitive> primitives;
    LargeVector<WideNode> nodes;
    LargeVector<std::uint32_t> lanes; ///< WideTree::primitives
    unsigned most_pending = 0;

    Part part(std::uint32_t first, std::uint32_t last, int level) const
    {
        SplitBox box = SplitBox::nothing();
        for (std::uint32_t i = first; i < last; ++i)
            box.include(primitives[i].box);
        return {box, first, last, level};
    }

    /// The children of a node: while lanes are left, the part whose split is worth most is split in two. That is the
    /// part with the largest surface area, but one of few leaves comes before larger ones, since it takes only a few
    /// lanes until its leaves are children themselves and no node has to be visited for them.
    std::vector<Part> children_of(const Part& node)
    {
        const auto worth = [](const Part& part) {
            constexpr std::uint32_t most_lanes = 6; // measured
            const std::uint32_t lanes_taken = (part.last - part.first - 1) / WideNode::lanes;
            return part.is_leaf() ? -1.0f : part.box.area() / static_cast<float>(std::min(lanes_taken, most_lanes));
        };
        std::vector<Part> parts = {node};
        while (parts.size() < WideNode::lanes) {
            const auto largest = std::max_element(parts.begin(), parts.end(),
                                                  [&](const Part& a, const Part& b) { return worth(a) < worth(b); });
            if (largest->is_leaf())
                break;
            const auto [box, first, last, level] = *largest;
            const std::uint32_t middle =
                level < levels_by_area ? split_by_area(primitives, first, last) : first + (last - first) / 2;
            *largest = part(first, middle, level + 1);
            parts.push_back(part(middle, last, level + 1));
        }
        return parts;
    }

    /// Adds a node and its subtree; returns its index. `pending`: number of children that are on the stack of a search
    /// when it reaches the node.
    std::uint32_t add_node(const Part& node, unsigned pending)
    {
        const auto number = static_cast<std::uint32_t>(nodes.size());
        nodes.push_back(empty_node());
        const std::vector<Part> children = children_of(node);
        const unsigned with_children = pending + static_cast<unsigned>(children.size());
        most_pending = std::max(most_pending, with_children);
        for (std::size_t i = 0; i < children.size(); ++i) {
            const Part& child = children[i];
            const std::uint32_t child_number = child.is_leaf() ? add_leaf(child) : add_node(child, with_children - 1);
            nodes[number].child[i] = child_number;
            for (unsigned axis = 0; axis < 3; ++axis) {
                nodes[number].plane[WideNode::low(axis) + i] = child.box.low[axis];
                nodes[number].plane[WideNode::high(axis) + i] = child.box.high[axis];
            }
        }
        return number;
    }

    /// Adds a leaf; returns it as an entry of WideNode::child.
    std::uint32_t add_leaf(const Part& leaf)
    {
        const auto number = static_cast<std::uint32_t>(lanes.size() / WideNode::lanes);
        for (std::uint32_t i = leaf.first; i < leaf.last; ++i)
            lanes.push_back(primitives[i].number);
        lanes.resize((number + 1) * std::size_t{WideNode::lanes}, WideTree::nothing);
        return WideNode::leaf_flag + number;
    }
};

} // namespace

WideTree::WideTree(const LargeVector<Bounds>& boxes, const std::vector<std::uint32_t>& numbers,
                   const FilterFrame& frame)
{
    Builder builder;
    builder.primitives.reserve(numbers.size());
    for (const std::uint32_t number : numbers)
        builder.primitives.push_back({in_frame(boxes[number], frame), number});
    if (!numbers.empty())
        builder.add_node(builder.part(0, static_cast<std::uint32_t>(numbers.size()), 0), 0);
    nodes_ = std::move(builder.nodes);
    primitives_ = std::move(builder.lanes);
    most_pending_ = builder.most_pending;
}

} // namespace multipath
