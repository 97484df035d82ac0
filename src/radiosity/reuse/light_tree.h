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

/// Binary tree over the emitting surfaces, for treating distant groups of them as one light (lightcuts: Walter et al.
/// 2005).
class LightTree
{
public:
    explicit LightTree(const Scene& scene);

    /// The lights below a node.
    struct Cluster
    {
        Vec3 centre;
        double radius = 0.0; ///< of a sphere about the centre that contains all of them
        Bounds bounds;
        double area = 0.0;                     ///< [m^2]
        double power = 0.0;                    ///< [W] mean of the channels
        Vec3 area_vector;                      ///< sum of area * normal
        std::array<double, 6> second_moment{}; ///< sum of area * normal normal^T: xx yy zz xy xz yz

        /// [m^2] Upper bound of the area seen from the direction (of length 1); exact if all surfaces have the same
        /// normal.
        double projected_area(Vec3 direction) const;
        /// [1] |sum of area * normal| / area, but at least 1/3. It is 1 if all normals agree. Not set for leaves.
        double coherence = 0.0;
    };

    bool empty() const { return pieces_.empty(); }
    const Cluster& cluster(std::uint32_t node) const { return clusters_[node]; } ///< node 0 is the root
    bool is_leaf(std::uint32_t node) const { return tree_.nodes()[node].is_leaf(); }
    std::uint32_t first_child(std::uint32_t node) const { return tree_.nodes()[node].first_child; }
    /// The light of a leaf, and the index of its surface.
    const FlatPiece& piece(std::uint32_t leaf) const { return pieces_[tree_.nodes()[leaf].begin]; }
    std::uint32_t surface(std::uint32_t leaf) const { return lights_[tree_.surface(tree_.nodes()[leaf].begin)]; }

    /// Samples a leaf below the node in proportion to power, by x in [0, 1).
    std::uint32_t choose(std::uint32_t node, double x) const;

private:
    std::vector<std::uint32_t> lights_; ///< surface of each light
    SurfaceTree tree_;                  ///< over the lights
    std::vector<Cluster> clusters_;     ///< per node
    std::vector<FlatPiece> pieces_;     ///< in the order of the tree
};

/// A cluster in the light cut of a patch.
struct SeenCluster
{
    std::uint32_t node;
    float irradiance; ///< [W/m^2] approximate, without obstacles; mean of the channels
};

/// The light cut of every patch: clusters of distant lights, and single near lights.
class LightCuts
{
public:
    /// A cluster is used as a whole if its radius plus that of the patch is below `angle` times their distance, less
    /// where its normals differ (`coherence`), since its projected area is then less certain.
    LightCuts(const Scene& scene, const LightTree& tree, double angle, int threads);

    const SeenCluster* begin(std::uint32_t patch) const { return clusters_.data() + first_[patch]; }
    const SeenCluster* end(std::uint32_t patch) const { return clusters_.data() + first_[patch + 1]; }
    double irradiance(std::uint32_t patch) const { return irradiance_[patch]; } ///< [W/m^2] sum over its clusters
    double bytes() const { return static_cast<double>(clusters_.capacity() * sizeof(SeenCluster)); }

    /// Power [W] from a light that touches the patch face to face, which no shadow ray can find.
    struct Contact
    {
        std::uint32_t patch;
        Rgb power;
    };
    const std::vector<Contact>& contacts() const { return contacts_; }

    /// True if the radii of light and patch together reach at least `angle` times their distance.
    static bool is_near(const LightTree::Cluster& light, const FlatPiece& patch, double angle);

private:
    std::vector<SeenCluster> clusters_;
    std::vector<std::size_t> first_; ///< index of the first cluster of each patch, and the total number
    std::vector<double> irradiance_;
    std::vector<Contact> contacts_;
};

} // namespace multipath
