#pragma once

#include "geometry/surface.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace multipath {

/// Binary tree that groups surfaces, or patches, by position and normal. Takes n log n steps to build.
class SurfaceTree
{
public:
    struct Node
    {
        std::uint32_t begin; ///< first of its surfaces in tree order
        std::uint32_t end;
        std::uint32_t parent;
        std::uint32_t first_child; ///< the second child follows it; 0 for a leaf

        bool is_leaf() const { return first_child == 0; }
    };

    /// Builds the tree of shape(0) ... shape(count - 1), with at most most_of_leaf of them in a leaf. Surfaces at one
    /// position with perpendicular normals are as far apart as parallel ones at a distance of 0.07 `diagonal`.
    SurfaceTree(std::uint32_t count, const std::function<Surface(std::uint32_t)>& shape, double diagonal,
                std::uint32_t most_of_leaf);

    const std::vector<Node>& nodes() const { return nodes_; } ///< parents before their children; the root is first
    std::uint32_t surface(std::uint32_t index) const { return order_[index]; } ///< by index in tree order

private:
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

/// Weighted sums of a value over rays, for its mean and variance.
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

/// For each surface, the sums of its own rays if there are `enough`; otherwise those of the smallest group around it
/// that has enough, or of all surfaces.
std::vector<RaySums> pooled(const SurfaceTree& tree, const std::vector<RaySums>& own, double enough, int threads);

} // namespace multipath
