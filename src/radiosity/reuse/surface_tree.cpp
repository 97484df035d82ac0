#include "radiosity/reuse/surface_tree.h"

#include "parallel/blocks.h"
#include "parallel/memory.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace multipath {

RaySums& RaySums::operator+=(const RaySums& other)
{
    rays += other.rays;
    weight += other.weight;
    value += other.value;
    square += other.square;
    return *this;
}

double RaySums::standard_deviation() const
{
    if (!(weight > 0.0))
        return 0.0;
    const double mean = value / weight;
    return std::sqrt(std::max(0.0, square / weight - mean * mean));
}

namespace {

constexpr std::size_t dimensions = 6;

/// A surface as a point in the space of positions and normals.
struct PlacedSurface
{
    std::array<float, dimensions> at;
    std::uint32_t surface;
};

std::vector<PlacedSurface> placed_surfaces(std::uint32_t count, const std::function<Surface(std::uint32_t)>& shape,
                                           double diagonal)
{
    constexpr double turn = 0.05; // scale of the normals, as a fraction of the diagonal
    std::vector<PlacedSurface> result = vector_with_capacity<PlacedSurface>(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Surface surface = shape(i);
        const Vec3 centre = surface.centre();
        const Vec3 normal = turn * diagonal * surface.normal();
        PlacedSurface placed{{}, i};
        std::size_t d = 0;
        for (const double x : {centre.x, centre.y, centre.z, normal.x, normal.y, normal.z})
            placed.at[d++] = static_cast<float>(x);
        result.push_back(placed);
    }
    return result;
}

/// Splits the range at the middle of its longest extent, or at the median if one side would be nearly empty. Returns
/// the first element of the second part.
PlacedSurface* split(PlacedSurface* first, PlacedSurface* last)
{
    std::array<float, dimensions> low = first->at;
    std::array<float, dimensions> high = first->at;
    for (const PlacedSurface* p = first; p != last; ++p)
        for (std::size_t d = 0; d < dimensions; ++d) {
            low[d] = std::min(low[d], p->at[d]);
            high[d] = std::max(high[d], p->at[d]);
        }
    std::size_t longest = 0;
    for (std::size_t d = 1; d < dimensions; ++d)
        if (high[d] - low[d] > high[longest] - low[longest])
            longest = d;
    const float middle = 0.5f * (low[longest] + high[longest]);
    PlacedSurface* cut = std::partition(first, last, [&](const PlacedSurface& p) { return p.at[longest] < middle; });
    const std::ptrdiff_t few = (last - first) / 64;
    if (cut - first > few && last - cut > few)
        return cut;
    cut = first + (last - first) / 2;
    std::nth_element(first, cut, last, [&](const PlacedSurface& a, const PlacedSurface& b) {
        return a.at[longest] < b.at[longest] || (a.at[longest] == b.at[longest] && a.surface < b.surface);
    });
    return cut;
}

} // namespace

SurfaceTree::SurfaceTree(std::uint32_t count, const std::function<Surface(std::uint32_t)>& shape, double diagonal,
                         std::uint32_t most_of_leaf)
{
    std::vector<PlacedSurface> placed = placed_surfaces(count, shape, diagonal);
    nodes_.push_back({0, count, 0, 0});
    for (std::uint32_t k = 0; k < nodes_.size(); ++k) {
        const Node node = nodes_[k];
        if (node.end - node.begin <= most_of_leaf) {
            // split() does not define the order within a part, which depends on the standard library.
            std::sort(placed.begin() + node.begin, placed.begin() + node.end,
                      [](const PlacedSurface& a, const PlacedSurface& b) { return a.surface < b.surface; });
            continue;
        }
        nodes_[k].first_child = static_cast<std::uint32_t>(nodes_.size());
        const PlacedSurface* const middle = split(placed.data() + node.begin, placed.data() + node.end);
        const auto cut = static_cast<std::uint32_t>(middle - placed.data());
        nodes_.push_back({node.begin, cut, k, 0});
        nodes_.push_back({cut, node.end, k, 0});
    }
    order_ = vector_with_capacity<std::uint32_t>(placed.size());
    for (const PlacedSurface& one : placed)
        order_.push_back(one.surface);
}

std::vector<RaySums> pooled(const SurfaceTree& tree, const std::vector<RaySums>& own, double enough, int threads)
{
    const std::vector<SurfaceTree::Node>& nodes = tree.nodes();
    const auto count = static_cast<std::uint32_t>(nodes.size());
    const auto for_leaves = [&](const auto& visit) {
        parallel_numbers(count, threads, [&](std::uint32_t k) {
            if (nodes[k].is_leaf())
                for (std::uint32_t p = nodes[k].begin; p < nodes[k].end; ++p)
                    visit(k, tree.surface(p));
        });
    };
    std::vector<RaySums> sums = large_vector<RaySums>(count);
    for_leaves([&](std::uint32_t k, std::uint32_t surface) { sums[k] += own[surface]; });
    for (std::uint32_t k = count; k-- > 1;)
        sums[nodes[k].parent] += sums[k];
    for (std::uint32_t k = 1; k < count; ++k)
        if (sums[k].rays < enough)
            sums[k] = sums[nodes[k].parent];
    std::vector<RaySums> result = large_vector<RaySums>(own.size());
    for_leaves([&](std::uint32_t k, std::uint32_t surface) {
        result[surface] = own[surface].rays < enough ? sums[k] : own[surface];
    });
    return result;
}

} // namespace multipath
