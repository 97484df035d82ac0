#include "geometry/area_split.h"

#include "geometry/wide_node.h"

#include <algorithm>
#include <limits>

namespace multipath {

namespace {

constexpr int bins = 16;

/// Which bin of an axis holds twice the centre of a thing.
struct Binning
{
    float low[4];
    float scale[4]; ///< 0 where all centres are the same

    Binning(const std::vector<SplitThing>& things, std::uint32_t first, std::uint32_t last)
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

} // namespace

SplitBox SplitBox::nothing()
{
    constexpr float most = std::numeric_limits<float>::max();
    return {{most, most, most, most}, {-most, -most, -most, -most}};
}

std::uint32_t split_by_area(std::vector<SplitThing>& things, std::uint32_t first, std::uint32_t last)
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

} // namespace multipath
