#include "image/shading/flat_regions.h"

#include "base/disjoint_sets.h"
#include "geometry/polygon.h"
#include "image/shading/patch_slopes.h"
#include "image/shading/smoothing_groups.h"
#include "sampling/random.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace multipath {

namespace {

/// Ratio of longest edge squared to area above which a shape is a needle; 2.3 for an equilateral triangle, 4 for half a
/// square.
constexpr double slender = 12.0;
constexpr double squares_per_reach = 4.0; ///< radius of a fit over the side of a square
/// Of the weight of the samples: keeps noise from tilting the fit across a narrow strip (ridge regression).
constexpr double ridge = 1e-3;
constexpr double same_plane = 1e-6; ///< [radian] largest angle between the normals of coplanar surfaces

double longest_edge(const Surface& shape)
{
    const FlatPolygon polygon = polygon_of(shape);
    double longest = 0.0;
    for (std::size_t k = 0; k < polygon.size; ++k)
        longest = std::max(longest, length(polygon.next(k) - polygon.corners[k]));
    return longest;
}

/// For each surface the first surface that it is connected to in one plane.
std::vector<std::uint32_t> flat_parts(const Scene& scene, const std::vector<Vec3>& normals)
{
    const auto count = static_cast<std::uint32_t>(scene.surfaces().size());
    std::vector<std::pair<std::uint64_t, std::uint32_t>> edges; // hash of both ends and the material; surface
    for (std::uint32_t s = 0; s < count; ++s) {
        std::vector<std::uint64_t> keys;
        for (const Vec3 corner : corners_of(scene.surfaces()[s]))
            keys.push_back(position_hash(scene, corner, scene.file().material[s]));
        for (std::size_t k = 0; k < keys.size(); ++k) {
            const auto [low, high] = std::minmax(keys[k], keys[(k + 1) % keys.size()]);
            edges.emplace_back(mix_bits(low) ^ high, s);
        }
    }
    std::sort(edges.begin(), edges.end());
    DisjointSets parts(count);
    for (std::size_t n = 1; n < edges.size(); ++n) {
        const std::uint32_t a = edges[n - 1].second;
        const std::uint32_t b = edges[n].second;
        if (edges[n - 1].first == edges[n].first && scene.surface_material(a).emittance == Rgb{} &&
            dot(normals[a], normals[b]) > 0.0 && length(cross(normals[a], normals[b])) < same_plane)
            parts.unite(a, b);
    }
    return parts.roots();
}

} // namespace

FlatRegions::FlatRegions(const VisiblePatches& patches, const std::vector<Vec3>& normals)
    : patches_(patches),
      normals_(normals),
      region_of_(patches.scene().surfaces().size(), none),
      reach_(region_of_.size())
{
    const Scene& scene = patches.scene();
    std::vector<double> longest;
    std::vector<bool> is_needle;
    for (std::uint32_t s = 0; s < region_of_.size(); ++s) {
        const Surface cell = scene.tessellation(s).uniform(0).cell(scene.surfaces()[s], 0); // all cells are similar
        longest.push_back(longest_edge(cell));
        is_needle.push_back(longest.back() * longest.back() > slender * cell.area());
    }
    if (std::find(is_needle.begin(), is_needle.end(), true) == is_needle.end())
        return;
    const std::vector<std::uint32_t> parts = flat_parts(scene, normals);
    std::vector<std::uint32_t> members(parts.size());
    std::vector<bool> has_needle(parts.size());
    for (std::uint32_t s = 0; s < parts.size(); ++s) {
        ++members[parts[s]];
        has_needle[parts[s]] = has_needle[parts[s]] || is_needle[s];
        reach_[parts[s]] = std::max(reach_[parts[s]], longest[s]);
    }
    for (std::uint32_t s = 0; s < parts.size(); ++s)
        if (has_needle[parts[s]] && members[parts[s]] > 1) {
            region_of_[s] = parts[s];
            add(s, true);
            if (scene.two_sided())
                add(s, false);
        }
}

FlatRegions::Plane FlatRegions::plane_of(std::uint32_t surface, bool front) const
{
    const std::uint32_t region = region_of_[surface];
    const Vec3 axis_u = normalized(patches_.scene().surfaces()[region].edge_u);
    return {region, front, reach_[region], axis_u, cross(normals_[region], axis_u)};
}

FlatRegions::Square FlatRegions::Plane::square(Vec3 point) const
{
    const auto index = [&](Vec3 axis) {
        return static_cast<std::int64_t>(std::floor(squares_per_reach / reach * dot(point, axis)));
    };
    return {region, front ? 0 : 1, index(axis_v), index(axis_u)};
}

/// Adds the patches on one side of a surface to the bins.
void FlatRegions::add(std::uint32_t surface, bool front)
{
    const Scene& scene = patches_.scene();
    const Plane plane = plane_of(surface, front);
    const std::uint32_t first = scene.first_patch(surface, front);
    const auto end = first + static_cast<std::uint32_t>(scene.tessellation(surface).cell_count());
    for (std::uint32_t patch = first; patch < end; ++patch) {
        const Vec3 centre = scene.patch(patch).shape.centre();
        const double weight = patches_.open_share(patch) * scene.area(patch);
        if (!(weight > 0.0))
            continue;
        Bin& bin = bins_[plane.square(centre)];
        bin.point = *patches_.open_point_near(patch, centre);
        bin.weight += weight;
        bin.centre = bin.centre + weight * centre;
        bin.value += weight * patches_.value(patch);
    }
}

std::optional<Rgb> FlatRegions::value(const CornerGroup& group) const
{
    const auto patch = static_cast<std::uint32_t>(group.slots.front() / CornerLattice::per_cell);
    const std::optional<Vec3> start = patches_.open_point_near(patch, group.corner);
    if (!start)
        return std::nullopt;
    const Plane plane = plane_of(group.surface, group.front);
    const Vec3 margin = plane.reach * (plane.axis_u + plane.axis_v);
    Square first = plane.square(group.corner - margin);
    Square last = plane.square(group.corner + margin);
    std::vector<const Bin*> around;
    std::vector<OpenPoint> points = {{*start, group.normal}};
    const Square corner_of_all = last;
    for (last[2] = first[2]; last <= corner_of_all; ++first[2], ++last[2])
        for (auto bin = bins_.lower_bound(first); bin != bins_.upper_bound(last); ++bin) {
            around.push_back(&bin->second);
            points.push_back({bin->second.point, group.normal});
        }
    struct Sample
    {
        double weight = 0.0;
        Vec3 way; ///< from the corner, along the axes, in units of the reach
        Rgb value;
    };
    std::vector<Sample> samples;
    Sample sum;
    const NearbyOccluders occluders(patches_.scene(), normals_, points);
    for (std::size_t k = 0; k < around.size(); ++k) {
        const double share = 1.0 / around[k]->weight;
        const Vec3 offset = (1.0 / plane.reach) * (share * around[k]->centre - group.corner);
        const Vec3 way = {dot(offset, plane.axis_u), dot(offset, plane.axis_v), 0.0};
        const double near = 1.0 - dot(way, way); // its square falls smoothly to 0 at the distance `reach`
        if (!(near > 0.0) || occluders.separate(points.front(), points[k + 1]))
            continue;
        const double weight = near * near * around[k]->weight;
        samples.push_back({weight, way, share * around[k]->value});
        sum = {sum.weight + weight, sum.way + weight * way, sum.value + weight * samples.back().value};
    }
    if (samples.empty())
        return std::nullopt;
    // A linear fit passes through the mean of the samples.
    const Vec3 middle = (1.0 / sum.weight) * sum.way;
    const Rgb mean = (1.0 / sum.weight) * sum.value;
    SlopeFit fit;
    for (const Vec3 axis : {Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}})
        fit.add(ridge * sum.weight, axis, {});
    for (const Sample& sample : samples)
        fit.add(sample.weight, sample.way - middle, sample.value - mean);
    const PatchSlope slope = fit.slope();
    const Rgb change = -middle.x * slope.along_u - middle.y * slope.along_v;
    return mean + by_channel([](double x, double low, double high) { return std::clamp(x, low, high); }, change,
                             fit.low(), fit.high());
}

} // namespace multipath
