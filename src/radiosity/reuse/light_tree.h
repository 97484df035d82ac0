#pragma once

#include "geometry/bounds.h"
#include "geometry/form_factor/exchange_area.h"
#include "radiosity/reuse/surface_tree.h"
#include "scene/scene.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// The emitting surfaces in a binary tree, of which distant parts can be taken together (lightcuts: Walter et al.
/// 2005).
class LightTree
{
public:
    explicit LightTree(const Scene& scene);

    /// The lights below a node.
    struct Cluster
    {
        Vec3 centre;
        double radius = 0.0; ///< around the centre; holds all of them
        Bounds bounds;
        double area = 0.0;                     ///< [m^2]
        double power = 0.0;                    ///< [W] mean of the channels
        Vec3 area_vector;                      ///< sum of area * normal
        std::array<double, 6> second_moment{}; ///< sum of area * normal normal^T: xx yy zz xy xz yz

        /// [m^2] Seen along the direction (of length 1): right for surfaces that look the same way, and never less
        /// than what is seen of them.
        double projected_area(Vec3 direction) const;
        double coherence = 0.0; ///< [1] |sum of area * normal| / area: 1 if all look the same way
    };

    bool empty() const { return pieces_.empty(); }
    const Cluster& cluster(std::uint32_t node) const { return clusters_[node]; } ///< node 0 is the root
    bool is_leaf(std::uint32_t node) const { return tree_.nodes()[node].is_leaf(); }
    std::uint32_t first_child(std::uint32_t node) const { return tree_.nodes()[node].first_child; }
    /// The light of a leaf, and the number of its surface.
    const FlatPiece& piece(std::uint32_t leaf) const { return pieces_[tree_.nodes()[leaf].begin]; }
    std::uint32_t surface(std::uint32_t leaf) const { return lights_[tree_.surface(tree_.nodes()[leaf].begin)]; }

    /// The leaf below the node that x in [0, 1) chooses, in proportion to power.
    std::uint32_t choose(std::uint32_t node, double x) const;

private:
    std::vector<std::uint32_t> lights_; ///< surfaces
    SurfaceTree tree_;                  ///< over them
    std::vector<Cluster> clusters_;     ///< per node
    std::vector<FlatPiece> pieces_;     ///< in the order of the tree
};

/// A part of the lights as a patch sees it.
struct SeenCluster
{
    std::uint32_t node;
    float irradiance; ///< [W/m^2] mean of the channels; about what the patch gets if nothing is in between
};

/// Of each patch the lights that it may see: distant ones together, near ones alone.
class LightCuts
{
public:
    /// A cluster is taken as a whole if its radius and that of the patch together are below `angle` of the distance; of
    /// lights that look different ways, of which the projected area is less well known, below a part of it.
    LightCuts(const Scene& scene, const LightTree& tree, double angle, int threads);

    const SeenCluster* begin(std::uint32_t patch) const { return clusters_.data() + first_[patch]; }
    const SeenCluster* end(std::uint32_t patch) const { return clusters_.data() + first_[patch + 1]; }
    double irradiance(std::uint32_t patch) const { return irradiance_[patch]; } ///< [W/m^2] the sum of its clusters
    double bytes() const { return static_cast<double>(clusters_.capacity() * sizeof(SeenCluster)); }

    /// Light [W] from a surface that touches the patch face to face, which no ray can ask for.
    struct Contact
    {
        std::uint32_t patch;
        Rgb power;
    };
    const std::vector<Contact>& contacts() const { return contacts_; }

    /// Is the light too near to the patch, or too large, to be seen under an angle of this size?
    static bool is_near(const LightTree::Cluster& light, const FlatPiece& patch, double angle);

private:
    std::vector<SeenCluster> clusters_;
    std::vector<std::size_t> first_; ///< of each patch; one more than patches
    std::vector<double> irradiance_;
    std::vector<Contact> contacts_;
};

} // namespace multipath
