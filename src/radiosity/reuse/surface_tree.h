#pragma once

#include "geometry/surface.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace multipath {

/// Surfaces, or patches, in a binary tree by where they lie and where they look. Built in n log n steps.
class SurfaceTree
{
public:
    struct Node
    {
        std::uint32_t begin; ///< of its surfaces in the order of the tree
        std::uint32_t end;
        std::uint32_t parent;
        std::uint32_t first_child; ///< the second follows; 0 for a leaf

        bool is_leaf() const { return first_child == 0; }
    };

    /// Of shape(0) ... shape(count - 1). Surfaces in one place that look in perpendicular directions are as far apart
    /// as ones at a distance of 0.07 `diagonal` that look the same way.
    SurfaceTree(std::uint32_t count, const std::function<Surface(std::uint32_t)>& shape, double diagonal,
                std::uint32_t most_of_leaf);

    const std::vector<Node>& nodes() const { return nodes_; } ///< parents before their children; the first is the root
    std::uint32_t surface(std::uint32_t place) const { return order_[place]; } ///< in the order of the tree

private:
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

/// What some rays found: sums over them.
struct RaySums
{
    double rays = 0.0;
    double weight = 0.0;
    double value = 0.0;  ///< weight * value
    double square = 0.0; ///< weight * value^2

    RaySums& operator+=(const RaySums& other);
    /// Of the value; 0 without rays.
    double standard_deviation() const;
};

/// For each surface the sums over itself if it has `enough` rays, else over the smallest group around it that has, or
/// over all.
std::vector<RaySums> pooled(const SurfaceTree& tree, const std::vector<RaySums>& own, double enough, int threads);

} // namespace multipath
