#include "geometry/intersector/tree.h"

#include "geometry/intersector/surface_block.h"
#include "parallel/memory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace multipath {

namespace {

/// Box in single precision; the fourth components only fill, so that a compiler can use vectors of four.
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

struct SplitThing
{
    SplitBox box;
    std::uint32_t number;
};

constexpr int bins = 16;

/// Which bin of an axis holds twice the centre of a thing.
struct Binning
{
    float low[4];
    float scale[4]; ///< 0 where all centres are the same

    Binning(const LargeVector<SplitThing>& things, std::uint32_t first, std::uint32_t last)
    {
        SplitBox centres = SplitBox::nothing();
        for (std::uint32_t t = first; t < last; ++t) {
            const SplitBox& box = things[t].box;
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
        const float place = (box.low[axis] + box.high[axis] - low[axis]) * scale[axis];
        return std::min(static_cast<int>(place), bins - 1);
    }
};

struct Bin
{
    SplitBox box = SplitBox::nothing();
    std::uint32_t count = 0;

    void include(const Bin& other)
    {
        box.include(other.box);
        count += other.count;
    }
    /// Leaves cost the same however many of their places are taken.
    float cost() const
    {
        const std::uint32_t leaves = (count + WideNode::lanes - 1) / WideNode::lanes;
        return leaves == 0 ? 0.0f : static_cast<float>(leaves) * box.area();
    }
};

/// The last bin of the left part and the cost, for one axis; bin -1 where nothing is to be split.
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

/// Sorts things first ... last - 1 into two parts, by the surface area heuristic over 16 bins along each axis, or into
/// halves where no split separates them. The beginning of the second part; neither is empty.
std::uint32_t split_by_area(LargeVector<SplitThing>& things, std::uint32_t first, std::uint32_t last)
{
    const Binning binning(things, first, last);
    Bin along[3][bins];
    for (std::uint32_t t = first; t < last; ++t)
        for (int axis = 0; axis < 3; ++axis) {
            Bin& bin = along[axis][binning.bin(things[t].box, axis)];
            bin.box.include(things[t].box);
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
    const auto begin = things.begin();
    const auto middle = std::partition(begin + first, begin + last, [&](const SplitThing& thing) {
        return binning.bin(thing.box, best_axis) <= best.last_left;
    });
    return static_cast<std::uint32_t>(middle - begin);
}

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
    Builder(LargeVector<SplitThing>& things, LargeVector<WideNode>& nodes, LargeVector<std::uint32_t>& lanes)
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

    LargeVector<SplitThing>& things_;
    LargeVector<WideNode>& nodes_;
    LargeVector<std::uint32_t>& lanes_;
};

} // namespace

WideTree::WideTree(const LargeVector<Bounds>& boxes, const std::vector<std::uint32_t>& numbers,
                   const FilterFrame& frame)
{
    LargeVector<SplitThing> things;
    things.reserve(numbers.size());
    for (const std::uint32_t number : numbers)
        things.push_back({in_frame(boxes[number], frame), number});
    Builder builder(things, nodes_, things_);
    const auto size = static_cast<std::uint32_t>(things.size());
    if (size > 0)
        builder.add_node({0, size, builder.box_of(0, size)}, 0);
}

} // namespace multipath
