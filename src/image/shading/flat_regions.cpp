// Surfaces that share an edge, a plane and a material are united with a union-find structure. The shared edges are
// found by sorting hashes of their end points. The patches of each resulting region with needles are binned on a
// regular grid in its plane, so that the fit at a corner costs the same however small the patches are.

#include "image/shading/flat_regions.h"

#include "base/disjoint_sets.h"
#include "geometry/bounds.h"
#include "geometry/polygon.h"
#include "parallel/blocks.h"
#include "sampling/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace multipath {

namespace {

/// Ratio of longest edge squared to area above which a shape is a needle; 2.3 for an equilateral triangle, 4 for half a
/// square.
constexpr double slender = 12.0;
constexpr double cells_per_reach = 4.0; ///< radius of a fit over the size of a grid cell
constexpr double most_bins = 1 << 22;   ///< per region
constexpr double same_plane = 1e-6;     ///< [radian] largest angle between the normals of coplanar surfaces

double longest_edge(const Surface& shape)
{
    const FlatPolygon polygon = polygon_of(shape);
    double longest = 0.0;
    for (std::size_t k = 0; k < polygon.size; ++k)
        longest = std::max(longest, length(polygon.next(k) - polygon.corners[k]));
    return longest;
}

/// The first cell of the surface's grid: all whole cells have its shape.
Surface first_cell(const Scene& scene, std::uint32_t surface)
{
    return scene.tessellation(surface).uniform(0).cell(scene.surfaces()[surface], 0);
}

bool is_needle(const Surface& shape)
{
    const double longest = longest_edge(shape);
    return longest * longest > slender * shape.area();
}

/// A hash of the ends of an edge, independent of their order, and a surface with this edge.
using Edge = std::pair<std::uint64_t, std::uint32_t>;

/// Weighted least-squares fit of a linear function, value = a + b x + c y (normal equations).
class LinearFit
{
public:
    void add(double weight, double x, double y, Rgb value)
    {
        const std::array<double, 3> basis = {1.0, x, y};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j)
                matrix_[i][j] += weight * basis[i] * basis[j];
            right_[i] += weight * basis[i] * value;
        }
        low_ = by_channel([](double a, double b) { return std::min(a, b); }, low_, value);
        high_ = by_channel([](double a, double b) { return std::max(a, b); }, high_, value);
    }
    bool empty() const { return !(matrix_[0][0] > 0.0); }

    /// The fitted value a at the origin, clamped to the range of the values; their mean if the positions do not
    /// determine a slope.
    Rgb at_origin() const
    {
        const auto subdeterminant = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
            return matrix_[i][k] * matrix_[j][l] - matrix_[i][l] * matrix_[j][k];
        };
        // The first row of the adjugate matrix (Cramer's rule).
        const double a = subdeterminant(1, 2, 1, 2);
        const double b = -subdeterminant(0, 2, 1, 2);
        const double c = subdeterminant(0, 1, 1, 2);
        const double determinant = matrix_[0][0] * a + matrix_[1][0] * b + matrix_[2][0] * c;
        const double scale = matrix_[0][0] * matrix_[0][0] * matrix_[0][0];
        if (!(determinant > 1e-5 * scale))
            return (1.0 / matrix_[0][0]) * right_[0];
        const Rgb fitted = (1.0 / determinant) * (a * right_[0] + b * right_[1] + c * right_[2]);
        return by_channel([](double x, double low, double high) { return std::clamp(x, low, high); }, fitted, low_,
                          high_);
    }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    std::array<std::array<double, 3>, 3> matrix_{};
    std::array<Rgb, 3> right_{};
    Rgb low_ = {infinity, infinity, infinity};
    Rgb high_ = {-infinity, -infinity, -infinity};
};

/// Unites surfaces of one material that share an edge and lie in one plane.
DisjointSets flat_sets(const Scene& scene, const std::vector<Vec3>& normals)
{
    const auto count = static_cast<std::uint32_t>(scene.surfaces().size());
    std::vector<Edge> edges;
    for (std::uint32_t s = 0; s < count; ++s) {
        std::vector<std::uint64_t> keys;
        for (const Vec3 corner : corners_of(scene.surfaces()[s]))
            keys.push_back(position_hash(scene, corner, scene.file().material[s]));
        for (std::size_t k = 0; k < keys.size(); ++k) {
            const auto [low, high] = std::minmax(keys[k], keys[(k + 1) % keys.size()]);
            edges.push_back({mix_bits(low) ^ high, s});
        }
    }
    std::sort(edges.begin(), edges.end());
    DisjointSets sets(count);
    for (std::size_t n = 1; n < edges.size(); ++n) {
        const auto [key, a] = edges[n - 1];
        const std::uint32_t b = edges[n].second;
        if (edges[n].first == key && dot(normals[a], normals[b]) > 0.0 &&
            length(cross(normals[a], normals[b])) < same_plane)
            sets.unite(a, b);
    }
    return sets;
}

} // namespace

std::size_t FlatRegions::Region::index(double x, std::size_t count) const
{
    return static_cast<std::size_t>(std::clamp(std::floor(x / cell), 0.0, static_cast<double>(count - 1)));
}

FlatRegions::FlatRegions(const VisiblePatches& patches, int threads)
    : patches_(patches), region_of_(patches.scene().surfaces().size(), none)
{
    const Scene& scene = patches.scene();
    normals_.resize(scene.surfaces().size());
    std::vector<char> needle(scene.surfaces().size());
    parallel_numbers(static_cast<std::uint32_t>(scene.surfaces().size()), threads, [&](std::uint32_t s) {
        normals_[s] = scene.surfaces()[s].normal();
        needle[s] = is_needle(first_cell(scene, s)) ? 1 : 0;
    });
    if (std::find(needle.begin(), needle.end(), 1) == needle.end())
        return;
    DisjointSets sets = flat_sets(scene, normals_);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> members; // set, surface
    for (std::uint32_t s = 0; s < scene.surfaces().size(); ++s)
        if (scene.surface_material(s).emittance == Rgb{})
            members.emplace_back(sets.root(s), s);
    std::sort(members.begin(), members.end());
    for (std::size_t first = 0, last; first < members.size(); first = last) {
        std::vector<std::uint32_t> surfaces;
        bool has_needles = false;
        for (last = first; last < members.size() && members[last].first == members[first].first; ++last) {
            surfaces.push_back(members[last].second);
            has_needles = has_needles || needle[members[last].second] != 0;
        }
        if (has_needles && surfaces.size() > 1)
            add_region(surfaces);
    }
}

void FlatRegions::add_region(const std::vector<std::uint32_t>& surfaces)
{
    const Scene& scene = patches_.scene();
    const Vec3 normal = normals_[surfaces.front()];
    Region region;
    region.axis_u = normalized(scene.surfaces()[surfaces.front()].edge_u);
    region.axis_v = cross(normal, region.axis_u);
    Bounds box; // along the axes
    for (const std::uint32_t surface : surfaces) {
        region_of_[surface] = static_cast<std::uint32_t>(regions_.size());
        region.reach = std::max(region.reach, longest_edge(first_cell(scene, surface)));
        for (const Vec3 corner : corners_of(scene.surfaces()[surface]))
            box.include(Vec3{dot(corner, region.axis_u), dot(corner, region.axis_v), dot(corner, normal)});
    }
    const Vec3 size = box.size();
    region.origin = box.low.x * region.axis_u + box.low.y * region.axis_v + box.low.z * normal;
    region.cell = std::max(region.reach / cells_per_reach, std::sqrt(size.x * size.y / most_bins));
    region.columns = static_cast<std::size_t>(size.x / region.cell) + 1;
    region.rows = static_cast<std::size_t>(size.y / region.cell) + 1;
    region.first_bin = bins_.size();
    bins_.resize(bins_.size() + (scene.two_sided() ? 2 : 1) * region.columns * region.rows);
    for (const std::uint32_t surface : surfaces)
        for (const bool front : {true, false})
            if (front || scene.two_sided())
                fill(region, surface, front);
    regions_.push_back(region);
}

void FlatRegions::fill(const Region& region, std::uint32_t surface, bool front)
{
    const Scene& scene = patches_.scene();
    const std::uint32_t first = scene.first_patch(surface, front);
    const auto end = first + static_cast<std::uint32_t>(scene.tessellation(surface).cell_count());
    for (std::uint32_t patch = first; patch < end; ++patch) {
        const Vec3 centre = scene.patch(patch).shape.centre();
        const double weight = patches_.open_share(patch) * scene.area(patch);
        const std::optional<Vec3> point = patches_.open_point_near(patch, centre);
        if (!point || !(weight > 0.0))
            continue;
        Bin& bin = bins_[region.bin(region.column(centre), region.row(centre), front)];
        bin.point = *point;
        bin.weight += weight;
        bin.centre = bin.centre + weight * centre;
        bin.value += weight * patches_.value(patch);
    }
}

std::optional<Rgb> FlatRegions::value(std::uint32_t surface, bool front, Vec3 corner, const OpenPoint& own) const
{
    const Region& region = regions_[region_of_[surface]];
    const Vec3 margin = region.reach * (region.axis_u + region.axis_v);
    std::vector<const Bin*> around;
    std::vector<OpenPoint> points = {own};
    for (std::size_t j = region.row(corner - margin); j <= region.row(corner + margin); ++j)
        for (std::size_t i = region.column(corner - margin); i <= region.column(corner + margin); ++i) {
            const Bin& bin = bins_[region.bin(i, j, front)];
            if (!(bin.weight > 0.0))
                continue;
            around.push_back(&bin);
            points.push_back({bin.point, own.normal});
        }
    const NearbyOccluders occluders(patches_.scene(), normals_, points);
    LinearFit fit;
    for (std::size_t k = 0; k < around.size(); ++k) {
        const Bin& bin = *around[k];
        const Vec3 way = (1.0 / region.reach) * ((1.0 / bin.weight) * bin.centre - corner);
        const double x = dot(way, region.axis_u);
        const double y = dot(way, region.axis_v);
        const double near = 1.0 - x * x - y * y; // its square falls smoothly to 0 at the distance `reach`
        if (near > 0.0 && !occluders.separate(own, points[k + 1]))
            fit.add(bin.weight * near * near, x, y, (1.0 / bin.weight) * bin.value);
    }
    return fit.empty() ? std::nullopt : std::optional<Rgb>(fit.at_origin());
}

} // namespace multipath
