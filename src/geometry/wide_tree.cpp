#include "geometry/wide_tree.h"

#include "geometry/area_split.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace multipath {

namespace {

constexpr std::uint32_t leaf_size = WideNode::lanes;
constexpr int levels_by_area = 28; // then halves, 32 levels at most: the stack of the filters has room for 64

/// Things first ... last - 1 of the list, which become one child of a node.
struct Range
{
    std::uint32_t first;
    std::uint32_t last;
    SplitBox box;

    std::uint32_t size() const { return last - first; }
};

float float_below(double x)
{
    const float nearest = static_cast<float>(x);
    return nearest <= x ? nearest : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

/// The box in the frame, wider by what the filters' arithmetic may lose: see block_filling.cpp.
SplitBox in_frame(const Bounds& box, const FilterFrame& frame)
{
    constexpr double margin = 2e-6;
    const Vec3 low = frame.to_frame(box.low);
    const Vec3 high = frame.to_frame(box.high);
    return {{float_below(low.x - margin), float_below(low.y - margin), float_below(low.z - margin), 0.0f},
            {-float_below(-high.x - margin), -float_below(-high.y - margin), -float_below(-high.z - margin), 0.0f}};
}

WideNode empty_node()
{
    WideNode node{};
    for (int axis = 0; axis < 3; ++axis) {
        std::fill(std::begin(node.low[axis]), std::end(node.low[axis]), std::numeric_limits<float>::max());
        std::fill(std::begin(node.high[axis]), std::end(node.high[axis]), std::numeric_limits<float>::lowest());
    }
    return node;
}

class Builder
{
public:
    Builder(std::vector<SplitThing>& things, std::vector<WideNode>& nodes, std::vector<std::uint32_t>& lanes)
        : things_(things), nodes_(nodes), lanes_(lanes)
    {
    }

    /// Makes the node over a range; its number.
    std::uint32_t add_node(const Range& range, int level)
    {
        const auto number = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back(empty_node());
        const std::vector<Range> children = split_up(range, level);
        for (std::size_t i = 0; i < children.size(); ++i) {
            const bool is_leaf = children[i].size() <= leaf_size;
            const std::uint32_t child = is_leaf ? add_block(children[i]) : add_node(children[i], level + 1);
            WideNode& node = nodes_[number];
            node.child[i] = child;
            for (int axis = 0; axis < 3; ++axis) {
                node.low[axis][i] = children[i].box.low[axis];
                node.high[axis][i] = children[i].box.high[axis];
            }
        }
        return number;
    }

    SplitBox box_of(std::uint32_t first, std::uint32_t last) const
    {
        SplitBox box = SplitBox::nothing();
        for (std::uint32_t i = first; i < last; ++i)
            box.include(things_[i].box);
        return box;
    }

private:
    /// Splits the largest range again and again until there are as many as a node holds.
    std::vector<Range> split_up(const Range& whole, int level)
    {
        std::vector<Range> ranges = {whole};
        while (ranges.size() < WideNode::lanes) {
            const auto largest = std::max_element(
                ranges.begin(), ranges.end(), [](const Range& a, const Range& b) { return priority(a) < priority(b); });
            if (largest->size() <= leaf_size)
                break;
            const Range range = *largest;
            const std::uint32_t middle = level < levels_by_area ? split_by_area(things_, range.first, range.last)
                                                                : range.first + range.size() / 2;
            *largest = {range.first, middle, box_of(range.first, middle)};
            ranges.push_back({middle, range.last, box_of(middle, range.last)});
        }
        return ranges;
    }

    static float priority(const Range& range) { return range.size() <= leaf_size ? -1.0f : range.box.area(); }

    std::uint32_t add_block(const Range& range)
    {
        const auto number = static_cast<std::uint32_t>(lanes_.size() / WideNode::lanes);
        for (std::uint32_t i = range.first; i < range.last; ++i)
            lanes_.push_back(things_[i].number);
        lanes_.resize((number + 1) * std::size_t{WideNode::lanes}, WideTree::nothing);
        return WideNode::block_flag + number;
    }

    std::vector<SplitThing>& things_;
    std::vector<WideNode>& nodes_;
    std::vector<std::uint32_t>& lanes_;
};

} // namespace

WideTree::WideTree(const std::vector<Bounds>& boxes, const std::vector<std::uint32_t>& numbers,
                   const FilterFrame& frame)
{
    std::vector<SplitThing> things;
    things.reserve(numbers.size());
    for (const std::uint32_t number : numbers)
        things.push_back({in_frame(boxes[number], frame), number});
    Builder builder(things, nodes_, things_);
    const auto size = static_cast<std::uint32_t>(things.size());
    if (size > 0)
        builder.add_node({0, size, builder.box_of(0, size)}, 0);
}

} // namespace multipath
