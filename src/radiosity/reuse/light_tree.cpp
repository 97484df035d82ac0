#include "radiosity/reuse/light_tree.h"

#include "base/elementary.h"
#include "base/lists.h"
#include "base/memory.h"
#include "geometry/intersector/shared_planes.h"
#include "geometry/polygon.h"
#include "parallel/blocks.h"
#include "transport/exchange/unoccluded_exchange.h"

namespace multipath {

namespace {

/// A surface as a point in the space of positions and normals.
struct PlacedSurface
{
    std::array<float, dimensions_of_place> at;
    std::uint32_t surface;
};

/// Splits the range at the middle of its longest extent, or at the median if one side would be nearly empty. Returns
/// the first element of the second part.
PlacedSurface* split(PlacedSurface* first, PlacedSurface* last)
{
    Extent box(first->at);
    for (const PlacedSurface* p = first; p != last; ++p)
        box.include(p->at);
    const std::size_t longest = box.longest();
    const float middle = 0.5f * (box.low[longest] + box.high[longest]);
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
    constexpr double turn = 0.05; // scale of the normals, as a fraction of the diagonal
    std::vector<PlacedSurface> placed = vector_with_capacity<PlacedSurface>(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Surface surface = shape(i);
        const Place place = place_of(surface.centre(), turn * diagonal * surface.normal());
        placed.push_back({{}, i});
        std::transform(place.begin(), place.end(), placed.back().at.begin(),
                       [](double x) { return static_cast<float>(x); });
    }
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
    order_ = mapped(placed, &PlacedSurface::surface);
}

std::vector<RaySums> pooled(const SurfaceTree& tree, const std::vector<RaySums>& own, double enough, OwnRays own_rays,
                            int threads)
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
    std::vector<RaySums> result = large_vector<RaySums>(own.size());
    for_leaves([&](std::uint32_t k, std::uint32_t surface) {
        const RaySums left_out = own_rays == OwnRays::left_out ? own[surface] : RaySums{};
        if (own_rays == OwnRays::counted && own[surface].rays >= enough) {
            result[surface] = own[surface];
            return;
        }
        while (k > 0 && sums[k].rays - left_out.rays < enough)
            k = nodes[k].parent;
        result[surface] = {sums[k].rays - left_out.rays, std::max(0.0, sums[k].weight - left_out.weight),
                           sums[k].value - left_out.value, sums[k].square - left_out.square};
    });
    return result;
}

// The cut of a patch is found by descending from the root: a cluster that is seen under a small angle is used as a
// whole, otherwise its children are visited. The irradiance from a cluster is estimated as that of a point light with
// the projected area of all its surfaces; that from a single light is computed with the exact exchange area. Clusters
// below the horizon of the patch are left out.

namespace {

std::vector<std::uint32_t> lamps(const Scene& scene)
{
    std::vector<std::uint32_t> result;
    for (std::uint32_t k = 0; k < scene.own_surfaces(); ++k)
        if (mean(scene.emittance(scene.first_patch(k))) > 0.0)
            result.push_back(k);
    return result;
}

LightTree::Cluster cluster_of(const FlatPiece& piece, double emittance)
{
    const Vec3 n = piece.normal;
    std::array<double, 6> second_moment = {n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.x * n.z, n.y * n.z};
    for (double& moment : second_moment)
        moment *= piece.area;
    return {piece.centre,           piece.radius,   piece.surface.bounds(), piece.area,
            piece.area * emittance, piece.area * n, second_moment};
}

/// The union of two clusters, without its radius.
LightTree::Cluster sum_of(const LightTree::Cluster& a, const LightTree::Cluster& b)
{
    LightTree::Cluster result = a;
    result.area += b.area;
    result.power += b.power;
    result.centre = (1.0 / result.power) * (a.power * a.centre + b.power * b.centre);
    result.bounds.include(b.bounds);
    result.area_vector = a.area_vector + b.area_vector;
    for (std::size_t m = 0; m < result.second_moment.size(); ++m)
        result.second_moment[m] += b.second_moment[m];
    constexpr double least =
        1.0 / 3.0; // lower bound, so that the cut does not contain every one of a thousand round lamps
    result.coherence = std::max(least, length(result.area_vector) / result.area);
    return result;
}

} // namespace

double LightTree::Cluster::projected_area(Vec3 d) const
{
    // With the cosine c of each surface, sum of A max(0, c) <= (sum of A c + sqrt(sum of A * sum of A c^2)) / 2 (Cauchy
    // and Schwarz).
    const std::array<double, 6>& m = second_moment;
    const double square = m[0] * d.x * d.x + m[1] * d.y * d.y + m[2] * d.z * d.z +
                          2.0 * (m[3] * d.x * d.y + m[4] * d.x * d.z + m[5] * d.y * d.z);
    return std::max(0.0, 0.5 * (dot(area_vector, d) + std::sqrt(std::max(0.0, area * square))));
}

LightTree::LightTree(const Scene& scene)
    : lights_(lamps(scene)),
      tree_(
          static_cast<std::uint32_t>(lights_.size()), [&](std::uint32_t k) { return scene.surfaces()[lights_[k]]; },
          scene.bounds().diagonal(), 1)
{
    const std::vector<SurfaceTree::Node>& nodes = tree_.nodes();
    for (std::uint32_t index = 0; index < lights_.size(); ++index)
        pieces_.push_back(scene.surfaces()[lights_[tree_.surface(index)]]);
    if (empty())
        return;
    clusters_.resize(nodes.size());
    for (std::size_t k = nodes.size(); k-- > 0;) {
        const std::uint32_t begin = nodes[k].begin;
        if (nodes[k].is_leaf()) {
            const std::uint32_t surface = lights_[tree_.surface(begin)];
            clusters_[k] = cluster_of(pieces_[begin], mean(scene.emittance(scene.first_patch(surface))));
            continue;
        }
        clusters_[k] = sum_of(clusters_[nodes[k].first_child], clusters_[nodes[k].first_child + 1]);
        for (std::uint32_t index = begin; index < nodes[k].end; ++index)
            clusters_[k].radius = std::max(clusters_[k].radius,
                                           length(pieces_[index].centre - clusters_[k].centre) + pieces_[index].radius);
    }
}

std::uint32_t LightTree::choose(std::uint32_t node, double x) const
{
    while (!is_leaf(node)) {
        const std::uint32_t child = first_child(node);
        const double share = clusters_[child].power / clusters_[node].power;
        node = x < share ? child : child + 1;
        x = std::min(x < share ? x / share : (x - share) / (1.0 - share), below_one);
    }
    return node;
}

namespace {

/// [m^2] Area of a light that lies on the patch, if the two are in contact. The light must be in the plane of the
/// patch.
double contact_area(const Scene& scene, std::uint32_t patch, std::uint32_t light, double touching)
{
    const Surface shape = scene.patch(patch).shape;
    double area = 0.0;
    const std::uint32_t first = scene.first_patch(light);
    for (std::uint32_t j = first; j < first + scene.tessellation(light).cell_count(); ++j) {
        const double overlap = exchange_area(shape, scene.patch(j).shape, touching);
        if (overlap > 0.0)
            area += overlap * share_in_contact(scene, patch, j);
    }
    return area;
}

/// Range of the heights of a box above the plane of the patch.
HeightRange heights_above(const FlatPiece& patch, const Bounds& bounds)
{
    const Vec3 n = patch.normal;
    const Vec3 half = 0.5 * bounds.size();
    const double middle = dot(n, bounds.centre() - patch.centre);
    const double extent = std::abs(n.x) * half.x + std::abs(n.y) * half.y + std::abs(n.z) * half.z;
    return {middle - extent, middle + extent};
}

} // namespace

struct LightCuts::CutFinder
{
    const Scene& scene;
    const LightTree& tree;
    double angle;
    double touching = coplanar_distance * scene.bounds().diagonal();

    Cut cut_of(std::uint32_t patch) const
    {
        const FlatPiece receiver = scene.patch(patch).shape;
        Cut cut;
        std::vector<std::uint32_t> stack(tree.empty() ? 0 : 1, 0);
        while (!stack.empty()) {
            const std::uint32_t node = stack.back();
            stack.pop_back();
            const LightTree::Cluster& light = tree.cluster(node);
            const Vec3 d = light.centre - receiver.centre;
            const HeightRange above = heights_above(receiver, light.bounds);
            if (above.high < -touching)
                continue;
            const bool leaf = tree.is_leaf(node);
            if (!leaf && LightCuts::is_near(light, receiver, angle * light.coherence)) {
                stack.push_back(tree.first_child(node) + 1);
                stack.push_back(tree.first_child(node));
                continue;
            }
            double irradiance = 0.0;
            if (leaf) {
                irradiance = leaf_irradiance(patch, receiver, node, cut.contact);
            } else if (above.high > touching) {
                const double distance = length(d);
                const double height = dot(receiver.normal, d);
                // If the plane cuts the light, at least about the height of the centre of the part above.
                const double rise = above.low < 0.0 ? std::max(height, 0.25 * above.high) : height;
                const double facing = light.projected_area((-1.0 / distance) * d);
                irradiance = rise * facing / (pi * distance * distance * distance) * light.power / light.area;
            }
            if (!(irradiance > 0.0))
                continue;
            cut.clusters.push_back({node, static_cast<float>(irradiance)});
            cut.irradiance += static_cast<double>(cut.clusters.back().irradiance);
        }
        cut.clusters.shrink_to_fit();
        return cut;
    }

    /// [W/m^2] Irradiance from a single light by exchange_area(). The power of a light in contact is added to `contact`
    /// instead.
    double leaf_irradiance(std::uint32_t patch, const FlatPiece& receiver, std::uint32_t leaf, Rgb& contact) const
    {
        const FlatPiece& light = tree.piece(leaf);
        const std::uint32_t surface = tree.surface(leaf);
        if (scene.surface_of(patch) == surface)
            return 0.0;
        const double emittance = tree.cluster(leaf).power / light.area;
        const bool opposite = dot(receiver.normal, light.normal) < -1.0 + 1e-9;
        if (opposite && heights(polygon_of(receiver.surface), light.centre, light.normal).within(touching)) {
            const double area = contact_area(scene, patch, surface, touching);
            contact += area * scene.emittance(scene.first_patch(surface));
            return 0.0;
        }
        return exchange_area(receiver, light, touching) / receiver.area * emittance;
    }
};

LightCuts::LightCuts(const Scene& scene, const LightTree& tree, double angle, int threads)
{
    const CutFinder finder{scene, tree, angle};
    cuts_.resize(scene.patch_count());
    parallel_numbers(scene.patch_count(), threads, [&](std::uint32_t i) { cuts_[i] = finder.cut_of(i); });
}

double LightCuts::bytes() const
{
    return sizeof(SeenCluster) *
           sum_over(cuts_, [](const Cut& cut) { return static_cast<double>(cut.clusters.capacity()); });
}

} // namespace multipath
