#pragma once

#include "geometry/surface.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace multipath {

/// Binary tree that groups surfaces, or patches, by position and normal. Each node holds a range of the surfaces in
/// tree order, in which the surfaces of every node are consecutive. Takes n log n steps to build.
class SurfaceTree
{
public:
    struct Node
    {
        std::uint32_t begin; ///< its surfaces are begin ... end - 1 in tree order
        std::uint32_t end;
        std::uint32_t parent;      ///< 0 for the root
        std::uint32_t first_child; ///< index of the first child; the second child is the next node; 0 for a leaf

        bool is_leaf() const { return first_child == 0; }
    };

    /// Builds the tree of shape(0) ... shape(count - 1), with at most most_of_leaf of them in a leaf. `diagonal` [scene
    /// units] of the scene sets the scale of the normals: the distance between two surfaces at the same position, with
    /// perpendicular normals, is taken to be that of two parallel surfaces 0.07 `diagonal` apart.
    SurfaceTree(std::uint32_t count, const std::function<Surface(std::uint32_t)>& shape, double diagonal,
                std::uint32_t most_of_leaf);

    const std::vector<Node>& nodes() const { return nodes_; } ///< parents before their children; the root is first
    /// Number of the surface at position `index` in tree order, as passed to `shape`.
    std::uint32_t surface(std::uint32_t index) const { return order_[index]; }

private:
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

/// Weighted sums of a value over rays, for its mean and variance.
struct RaySums
{
    double rays = 0.0;   ///< number of rays
    double weight = 0.0; ///< sum of weights
    double value = 0.0;  ///< sum of weight * value
    double square = 0.0; ///< sum of weight * value^2

    RaySums& operator+=(const RaySums& other);
    /// Weighted standard deviation of the value; 0 without weights.
    double standard_deviation() const;
};

/// For each surface, the sums of its own rays if these are `enough` or more. Otherwise, the sums over the smallest node
/// of the tree that contains the surface and has enough rays, or over all surfaces if no node has enough. `own`: the
/// sums of each surface alone, in the order of their indices.
std::vector<RaySums> pooled(const SurfaceTree& tree, const std::vector<RaySums>& own, double enough, int threads);

} // namespace multipath
