// Bounding volume hierarchy with 16 children per node, built in two steps. First a binary tree is split top-down by the
// surface area heuristic (Goldsmith and Salmon 1987) over 16 bins along each axis (Wald 2007). Then its nodes are
// collapsed into wide nodes (Wald, Benthin, Boulos 2008).

#include "geometry/intersector/tree.h"

#include "base/memory.h"
#include "geometry/intersector/surface_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

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

/// Assigns primitives to bins along each axis by twice their centres.
struct Binning
{
    float low[4];
    float scale[4]; ///< bins per length; 0 along an axis where all centres are equal

    Binning(const LargeVector<SplitPrimitive>& primitives, std::uint32_t first, std::uint32_t last)
    {
        SplitBox centres = SplitBox::nothing();
        for (std::uint32_t t = first; t < last; ++t) {
            const SplitBox& box = primitives[t].box;
            SplitBox centre;
            for (int i = 0; i < 4; ++i)
                centre.low[i] = centre.high[i] = box.low[i] + box.high[i];
            centres.include(centre);
        }
        for (int i = 0; i < 4; ++i) {
            low[i] = centres.low[i];
            const float width = centres.high[i] - centres.low[i];
            const float exact = static_cast<float>(bins) / width;
            scale[i] = width > 0.0f && exact < std::numeric_limits<float>::max() ? exact : 0.0f;
        }
    }

    int bin(const SplitBox& box, int axis) const
    {
        const float position = (box.low[axis] + box.high[axis] - low[axis]) * scale[axis];
        return std::min(static_cast<int>(position), bins - 1);
    }
};

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

/// Best split along one axis: the last bin of the left part (-1 if there is no split) and the cost.
struct Cut
{
    int last_left = -1;
    float cost = std::numeric_limits<float>::max();
};

Cut cheapest_cut(const Bin (&along)[bins], std::uint32_t count)
{
    float left_cost[bins];
    Bin left;
    for (int b = 0; b < bins; ++b) {
        left.include(along[b]);
        left_cost[b] = left.cost();
    }
    Cut best;
    Bin right;
    for (int b = bins - 1; b > 0; --b) {
        right.include(along[b]);
        const float cost = left_cost[b - 1] + right.cost();
        if (right.count > 0 && right.count < count && cost < best.cost)
            best = {b - 1, cost};
    }
    return best;
}

/// Partitions the primitives first ... last - 1 at the cheapest split of all axes, or into halves if no split separates
/// them. Returns the beginning of the second part; neither part is empty.
std::uint32_t split_by_area(LargeVector<SplitPrimitive>& primitives, std::uint32_t first, std::uint32_t last)
{
    const Binning binning(primitives, first, last);
    Bin along[3][bins];
    for (std::uint32_t t = first; t < last; ++t)
        for (int axis = 0; axis < 3; ++axis) {
            Bin& bin = along[axis][binning.bin(primitives[t].box, axis)];
            bin.box.include(primitives[t].box);
            ++bin.count;
        }
    Cut best;
    int best_axis = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Cut cut = cheapest_cut(along[axis], last - first);
        if (cut.cost < best.cost) {
            best = cut;
            best_axis = axis;
        }
    }
    const std::uint32_t halves = first + (last - first) / 2;
    if (best.last_left < 0)
        return halves;
    const auto begin = primitives.begin();
    const auto middle = std::partition(begin + first, begin + last, [&](const SplitPrimitive& primitive) {
        return binning.bin(primitive.box, best_axis) <= best.last_left;
    });
    return static_cast<std::uint32_t>(middle - begin);
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

/// Node of the binary tree.
struct BinaryNode
{
    SplitBox box;
    std::uint32_t first; ///< its primitives are first ... last - 1 in the list
    std::uint32_t last;
    std::uint32_t right; ///< index of the second child, 0 without children; the first child follows the node

    std::uint32_t size() const { return last - first; }
    bool is_split() const { return right != 0; }
};

constexpr std::uint32_t not_split = WideNode::lanes; ///< nodes of so few primitives become leaves
constexpr int levels_by_area = 38;                   ///< then halves: at most 64 levels of fewer than 2^26 primitives

/// The nodes of the binary tree that become the children of the wide node made of node n: the largest of them, by
/// surface area, is replaced by its two children while lanes are left.
std::vector<std::uint32_t> wide_children(const std::vector<BinaryNode>& nodes, std::uint32_t n)
{
    std::vector<std::uint32_t> children = {n};
    while (children.size() < WideNode::lanes) {
        const auto split_area = [&](std::uint32_t c) { return nodes[c].is_split() ? nodes[c].box.area() : -1.0f; };
        const auto largest = std::max_element(children.begin(), children.end(), [&](std::uint32_t a, std::uint32_t b) {
            return split_area(a) < split_area(b);
        });
        if (!nodes[*largest].is_split())
            break;
        const std::uint32_t split = *largest;
        *largest = split + 1;
        children.push_back(nodes[split].right);
    }
    return children;
}

/// Builds the binary tree and from it the wide tree.
class Builder
{
public:
    Builder(LargeVector<SplitPrimitive>& primitives, LargeVector<WideNode>& nodes, LargeVector<std::uint32_t>& lanes)
        : primitives_(primitives), nodes_(nodes), lanes_(lanes)
    {
    }

    /// Returns the largest number of children on the stack of a depth-first search.
    unsigned build()
    {
        add_binary(0, static_cast<std::uint32_t>(primitives_.size()), 0);
        unsigned most_pending = 0;
        add_node(0, 0, most_pending);
        return most_pending;
    }

private:
    SplitBox box_of(std::uint32_t first, std::uint32_t last) const
    {
        SplitBox box = SplitBox::nothing();
        for (std::uint32_t i = first; i < last; ++i)
            box.include(primitives_[i].box);
        return box;
    }

    /// Adds the binary subtree over these primitives; returns its index.
    std::uint32_t add_binary(std::uint32_t first, std::uint32_t last, int level)
    {
        const auto number = static_cast<std::uint32_t>(binary_.size());
        binary_.push_back({box_of(first, last), first, last, 0});
        if (last - first <= not_split)
            return number;
        const std::uint32_t middle =
            level < levels_by_area ? split_by_area(primitives_, first, last) : first + (last - first) / 2;
        add_binary(first, middle, level + 1);
        const std::uint32_t right = add_binary(middle, last, level + 1);
        binary_[number].right = right;
        return number;
    }

    /// Adds the wide node made of a binary node, and its subtree; returns its index. `pending`: number of children that
    /// are on the stack of a search when it reaches the node.
    std::uint32_t add_node(std::uint32_t of, unsigned pending, unsigned& most_pending)
    {
        const auto number = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back(empty_node());
        const std::vector<std::uint32_t> children = wide_children(binary_, of);
        const unsigned with_children = pending + static_cast<unsigned>(children.size());
        most_pending = std::max(most_pending, with_children);
        for (std::size_t i = 0; i < children.size(); ++i) {
            const BinaryNode child = binary_[children[i]];
            const std::uint32_t child_number =
                child.is_split() ? add_node(children[i], with_children - 1, most_pending) : add_leaf(child);
            WideNode& node = nodes_[number];
            node.child[i] = child_number;
            for (unsigned axis = 0; axis < 3; ++axis) {
                node.plane[WideNode::low(axis) + i] = child.box.low[axis];
                node.plane[WideNode::high(axis) + i] = child.box.high[axis];
            }
        }
        return number;
    }

    /// Adds a leaf; returns it as an entry of WideNode::child.
    std::uint32_t add_leaf(const BinaryNode& leaf)
    {
        const auto number = static_cast<std::uint32_t>(lanes_.size() / WideNode::lanes);
        for (std::uint32_t i = leaf.first; i < leaf.last; ++i)
            lanes_.push_back(primitives_[i].number);
        lanes_.resize((number + 1) * std::size_t{WideNode::lanes}, WideTree::nothing);
        return WideNode::leaf_flag + number;
    }

    LargeVector<SplitPrimitive>& primitives_;
    LargeVector<WideNode>& nodes_;
    LargeVector<std::uint32_t>& lanes_;
    std::vector<BinaryNode> binary_;
};

} // namespace

WideTree::WideTree(const LargeVector<Bounds>& boxes, const std::vector<std::uint32_t>& numbers,
                   const FilterFrame& frame)
{
    LargeVector<SplitPrimitive> split;
    split.reserve(numbers.size());
    for (const std::uint32_t number : numbers)
        split.push_back({in_frame(boxes[number], frame), number});
    if (!split.empty())
        most_pending_ = Builder(split, nodes_, primitives_).build();
}

} // namespace multipath
