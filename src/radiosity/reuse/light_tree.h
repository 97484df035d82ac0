#pragma once

#include "geometry/bounds.h"
#include "geometry/form_factor/exchange_area.h"
#include "geometry/surface.h"
#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace multipath {

constexpr double below_one = 0x1.fffffffffffffp-1; ///< the largest number in [0, 1)

/// A position and a direction, a normal times a length that tells how much directions count.
constexpr std::size_t dimensions_of_place = 6;
using Place = std::array<double, dimensions_of_place>;

inline Place place_of(Vec3 position, Vec3 direction)
{
    return {position.x, position.y, position.z, direction.x, direction.y, direction.z};
}

/// Bounding box of points with the coordinates of a Place.
template <class Point>
struct Extent
{
    Point low;
    Point high;

    explicit Extent(const Point& point) : low(point), high(point) {}
    void include(const Point& point)
    {
        for (std::size_t d = 0; d < point.size(); ++d) {
            low[d] = std::min(low[d], point[d]);
            high[d] = std::max(high[d], point[d]);
        }
    }
    auto length(std::size_t d) const { return high[d] - low[d]; }
    std::size_t longest() const ///< dimension of the greatest length
    {
        std::size_t result = 0;
        for (std::size_t d = 1; d < low.size(); ++d)
            if (length(d) > length(result))
                result = d;
        return result;
    }
};

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

    RaySums& operator+=(const RaySums& other)
    {
        rays += other.rays;
        weight += other.weight;
        value += other.value;
        square += other.square;
        return *this;
    }
    double mean() const { return quotient(value, weight); } ///< of the value; 0 without weights
    double standard_deviation() const { return std::sqrt(std::max(0.0, quotient(square, weight) - mean() * mean())); }
};

/// Whether pooled() counts the rays of a surface itself. What is decided by sums without them is independent of what
/// they have found.
enum class OwnRays { counted, left_out };

/// For each surface, the sums over the smallest node of the tree that contains the surface and has `enough` rays, or
/// over all surfaces if no node has enough. A surface whose own rays are enough keeps their sums, if they are counted.
/// `own`: the sums of each surface alone, in the order of their indices.
std::vector<RaySums> pooled(const SurfaceTree& tree, const std::vector<RaySums>& own, double enough, OwnRays own_rays,
                            int threads);

/// Binary tree over the lights, the emitting surfaces of a scene without the sky, for treating a distant group of
/// lights as one light (lightcuts: Walter et al. 2005). Each leaf is a single light.
class LightTree
{
public:
    explicit LightTree(const Scene& scene);

    /// The lights below a node.
    struct Cluster
    {
        Vec3 centre;
        double radius = 0.0; ///< [scene units] radius of a sphere about the centre that contains all lights
        Bounds bounds;
        double area = 0.0;                     ///< [m^2] total area
        double power = 0.0;                    ///< [W] total power, mean of the channels
        Vec3 area_vector;                      ///< [m^2] sum of area * normal
        std::array<double, 6> second_moment{}; ///< [m^2] sum of area * normal normal^T: xx yy zz xy xz yz

        /// [m^2] Upper bound of the projected area of the fronts, seen by a viewer in this direction (a unit vector
        /// from the lights to the viewer). Exact if all lights have the same normal.
        double projected_area(Vec3 direction) const;
        /// [1] |sum of area * normal| / area, but at least 1/3. It is 1 if all normals agree. 0 (not set) for leaves.
        double coherence = 0.0;
    };

    bool empty() const { return pieces_.empty(); }                               ///< true without lights
    const Cluster& cluster(std::uint32_t node) const { return clusters_[node]; } ///< node 0 is the root
    bool is_leaf(std::uint32_t node) const { return tree_.nodes()[node].is_leaf(); }
    /// The first of the two children of an inner node; the other one is the next node.
    std::uint32_t first_child(std::uint32_t node) const { return tree_.nodes()[node].first_child; }
    /// The light of a leaf.
    const FlatPiece& piece(std::uint32_t leaf) const { return pieces_[tree_.nodes()[leaf].begin]; }
    /// The index in the scene of the surface that is the light of a leaf.
    std::uint32_t surface(std::uint32_t leaf) const { return lights_[tree_.surface(tree_.nodes()[leaf].begin)]; }

    /// Samples a leaf below the node with a probability in proportion to its power, given x uniform in [0, 1). Returns
    /// the node itself if it is a leaf.
    std::uint32_t choose(std::uint32_t node, double x) const;

private:
    std::vector<std::uint32_t> lights_; ///< surface of each light
    SurfaceTree tree_;                  ///< tree over the indices in lights_
    std::vector<Cluster> clusters_;     ///< per node
    std::vector<FlatPiece> pieces_;     ///< per light, in the order of the tree
};

/// A cluster in the light cut of a patch.
struct SeenCluster
{
    std::uint32_t node; ///< node of the LightTree
    float irradiance;   ///< [W/m^2] irradiance of the patch by the cluster without obstacles, mean of the channels;
                        ///< approximate unless the node is a leaf
};

/// The light cut of every patch: a list of clusters that together contain each light in front of the patch once.
/// Distant lights are grouped into clusters, near ones are leaves. Clusters without irradiance are left out.
class LightCuts
{
public:
    /// A cluster is used as a whole if its radius plus that of the patch is below `angle` [1] times its coherence times
    /// the distance of their centres. (Where the normals of the lights differ, their projected area is less certain.)
    LightCuts(const Scene& scene, const LightTree& tree, double angle, int threads);

    const std::vector<SeenCluster>& of(std::uint32_t patch) const { return cuts_[patch].clusters; }
    double irradiance(std::uint32_t patch) const { return cuts_[patch].irradiance; } ///< [W/m^2] sum over its clusters
    /// Power [W] that the patch receives from lights that touch it face to face. No shadow ray can find such a light,
    /// and no cluster contains this power.
    Rgb contact(std::uint32_t patch) const { return cuts_[patch].contact; }
    double bytes() const; ///< [bytes] memory of all clusters

    /// True if the radii of light and patch together are at least `angle` [1] times the distance of their centres.
    static bool is_near(const LightTree::Cluster& light, const FlatPiece& patch, double angle)
    {
        const double size = light.radius + patch.radius;
        const Vec3 d = light.centre - patch.centre;
        return size * size >= angle * angle * dot(d, d);
    }

private:
    struct Cut
    {
        std::vector<SeenCluster> clusters;
        double irradiance = 0.0;
        Rgb contact;
    };
    struct CutFinder;

    std::vector<Cut> cuts_; ///< per patch
};

} // namespace multipath
