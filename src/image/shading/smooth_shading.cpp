#include "image/shading/smooth_shading.h"

#include "image/shading/corner_groups.h"
#include "image/shading/flat_regions.h"
#include "image/shading/patch_slopes.h"
#include "image/shading/smoothing_groups.h"
#include "image/shading/visible_patches.h"
#include "parallel/blocks.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <tuple>
#include <utility>

namespace multipath {

namespace {

/// Below this reflectance the irradiance in a channel is unknown; without_texture() uses the mean of the other
/// channels.
constexpr double darkest_texture = 1e-6;

/// [W/m^2] Irradiance; 0 where it is unknown.
Rgb light_on(Rgb reflected, Rgb reflectance)
{
    return by_channel([](double b, double rho) { return rho > darkest_texture ? b / rho : 0.0; }, reflected,
                      reflectance);
}

} // namespace

std::vector<Rgb> without_texture(const Scene& scene, std::vector<Rgb> radiosity)
{
    if (scene.file().textures.empty())
        return radiosity;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        if (!scene.is_textured(scene.surface_of(i)))
            continue;
        const Rgb rho = scene.reflectance(i);
        const Rgb light = light_on(radiosity[i] - scene.emittance(i), rho);
        const Rgb unknown = by_channel([](double r) { return r > darkest_texture ? 0.0 : 1.0; }, rho);
        const double known_channels = 3.0 - (unknown.r + unknown.g + unknown.b);
        const double usual = quotient(light.r + light.g + light.b, known_channels);
        radiosity[i] = scene.emittance(i) + scene.material_of(i).reflectance * (light + usual * unknown);
    }
    return radiosity;
}

// The values at the corners of the patches are found in three steps. First each surface gets values from its own
// patches alone (CornerGroup), or in a region of needles from a fit (FlatRegions). Then coinciding corners of different
// surfaces are joined if they belong to one smoothing group and no occluder separates them: the triangles of a sphere
// or the rectangles of a ceiling look like one surface, while the edges of a box and between materials stay sharp.
// Finally hanging nodes are interpolated.

namespace {

constexpr std::size_t most_joined = 1000; // more groups at one position are not joined, to bound the time

/// Equal for coinciding corners of one material, both on fronts or both on backs.
std::uint64_t border_key(const Scene& scene, std::uint32_t surface, bool front, Vec3 corner)
{
    return position_hash(scene, corner, 2 * std::uint64_t{scene.file().material[surface]} + (front ? 1 : 0));
}

std::uint64_t border_key(const Scene& scene, const CornerGroup& group)
{
    return border_key(scene, group.surface, group.front, group.corner);
}

/// The surfaces that are not shown but have a corner that coincides with that of a group.
std::vector<char> surfaces_beside(const Scene& scene, const std::vector<char>& shown,
                                  const std::deque<CornerGroup>& groups, int threads)
{
    std::vector<std::uint64_t> keys;
    for (const CornerGroup& group : groups)
        if (group.on_border)
            keys.push_back(border_key(scene, group));
    std::sort(keys.begin(), keys.end());
    const auto coincides = [&](std::uint32_t surface, bool front) {
        const CornerLattice lattice(scene.tessellation(surface));
        const std::vector<GridPoint> points = lattice.points();
        return std::any_of(points.begin(), points.end(), [&](GridPoint point) {
            const Vec3 corner = scene.surfaces()[surface].at(lattice.u(point), lattice.v(point));
            return std::binary_search(keys.begin(), keys.end(), border_key(scene, surface, front, corner));
        });
    };
    std::vector<char> result(shown.size());
    parallel_numbers(static_cast<std::uint32_t>(shown.size()), threads, [&](std::uint32_t surface) {
        if (shown[surface] == 0)
            result[surface] = coincides(surface, true) || (scene.two_sided() && coincides(surface, false)) ? 1 : 0;
    });
    return result;
}

/// True if some point of one group is not occluded from some point of the other.
bool joins(const NearbyOccluders& occluders, const CornerGroup& a, const CornerGroup& b)
{
    for (const OpenPoint& from : a.points)
        for (const OpenPoint& to : b.points)
            if (!occluders.separate(from, to))
                return true;
    return false;
}

/// Stores a value in the slots of a group. Every slot belongs to one group, so that threads can do so at the same time.
void put(const CornerGroup& group, Rgb value, std::vector<Rgb>& corners)
{
    for (const std::size_t slot : group.slots)
        corners[slot] = value;
}

/// Joins groups at one position: the value of each becomes the weighted mean of itself and the groups it is joined to.
void join_coinciding(const Scene& scene, const std::vector<Vec3>& normals,
                     const std::vector<const CornerGroup*>& groups, std::vector<Rgb>& corners)
{
    const std::size_t count = groups.size();
    std::vector<std::pair<std::size_t, std::size_t>> pairs; // of groups that may join
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j)
            if (groups[i]->surface != groups[j]->surface && same_smoothing_group(groups[i]->normal, groups[j]->normal))
                pairs.emplace_back(i, j);
    if (pairs.empty())
        return;
    std::vector<OpenPoint> points;
    for (const CornerGroup* group : groups)
        points.insert(points.end(), group->points.begin(), group->points.end());
    if (points.empty())
        return;
    struct Sum
    {
        Rgb value;
        double weight = 0.0;

        void add(const CornerGroup& group)
        {
            value += group.weight * group.value;
            weight += group.weight;
        }
    };
    std::vector<Sum> others(count);
    const NearbyOccluders occluders(scene, normals, points);
    for (const auto& [i, j] : pairs)
        if (joins(occluders, *groups[i], *groups[j])) {
            others[i].add(*groups[j]);
            others[j].add(*groups[i]);
        }
    for (std::size_t i = 0; i < count; ++i) {
        const auto [sum, weight] = others[i];
        const CornerGroup& own = *groups[i];
        if (weight > 0.0)
            put(own, 1.0 / (own.weight + weight) * (sum + own.weight * own.value), corners);
    }
}

/// Joins coinciding groups of different surfaces.
void join_borders(const Scene& scene, const std::vector<Vec3>& normals, const std::deque<CornerGroup>& groups,
                  int threads, std::vector<Rgb>& corners)
{
    // Sorted also by slot, so that sums do not depend on the sorting algorithm.
    std::vector<std::tuple<std::uint64_t, std::size_t, const CornerGroup*>> order;
    for (const CornerGroup& group : groups)
        if (group.on_border)
            order.emplace_back(border_key(scene, group), group.slots.front(), &group);
    std::sort(order.begin(), order.end());
    std::vector<std::pair<std::size_t, std::size_t>> runs; // first and end, in `order`, of groups that coincide
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (k == 0 || std::get<0>(order[k]) != std::get<0>(order[k - 1]))
            runs.emplace_back(k, k);
        runs.back().second = k + 1;
    }
    // By surface, for locality of memory access.
    const auto first_slot = [&order](const auto& run) { return std::get<1>(order[run.first]); };
    std::sort(runs.begin(), runs.end(), [&](const auto& a, const auto& b) { return first_slot(a) < first_slot(b); });
    parallel_numbers(static_cast<std::uint32_t>(runs.size()), threads, [&](std::uint32_t k) {
        const auto [first, end] = runs[k];
        if (end - first > most_joined)
            return;
        std::vector<const CornerGroup*> coinciding;
        for (std::size_t n = first; n < end; ++n)
            coinciding.push_back(std::get<2>(order[n]));
        join_coinciding(scene, normals, coinciding, corners);
    });
}

/// Interpolates hanging nodes between the ends of the edge on which they lie. Edges of larger patches come first, since
/// the ends of an edge may be hanging nodes on edges of still larger patches.
void interpolate_hanging_nodes(const std::deque<CornerGroup>& groups, std::vector<Rgb>& corners)
{
    std::vector<const CornerGroup*> hanging;
    for (const CornerGroup& group : groups)
        if (group.edge)
            hanging.push_back(&group);
    std::stable_sort(hanging.begin(), hanging.end(),
                     [](const CornerGroup* a, const CornerGroup* b) { return a->edge->level < b->edge->level; });
    for (const CornerGroup* group : hanging) {
        const CornerGroup::Edge& edge = *group->edge;
        put(*group, (1.0 - edge.share) * corners[edge.from] + edge.share * corners[edge.to], corners);
    }
}

/// The values in the slots of all patches. `shown`: as for SmoothShading.
std::vector<Rgb> corner_values(const VisiblePatches& patches, const std::vector<PatchSlope>& slopes, int threads,
                               const std::vector<char>& shown)
{
    const Scene& scene = patches.scene();
    std::vector<Rgb> corners(CornerLattice::per_cell * slopes.size());
    std::vector<Vec3> normals;
    for (const Surface& surface : scene.surfaces())
        normals.push_back(surface.normal());
    const FlatRegions regions(patches, normals);
    std::deque<CornerGroup> groups; // whose values may change later
    const auto add = [&](const std::vector<char>& chosen) {
        std::vector<std::pair<std::uint32_t, bool>> sides; // surface, front
        for (std::uint32_t surface = 0; surface < chosen.size(); ++surface)
            for (const bool front : {true, false})
                if (chosen[surface] != 0 && (front || scene.two_sided()))
                    sides.emplace_back(surface, front);
        std::vector<std::vector<CornerGroup>> found(sides.size());
        const auto count = static_cast<std::uint32_t>(sides.size());
        const std::uint32_t together = 1 + count / 256; // few, as surfaces differ in size
        parallel_ranges(count, together, threads, [&](std::uint32_t first, std::uint32_t end) {
            for (std::uint32_t k = first; k < end; ++k) {
                for (CornerGroup& group : corner_groups(patches, slopes, sides[k].first, sides[k].second)) {
                    if (regions.contains(group.surface))
                        group.value = regions.value(group).value_or(group.value);
                    put(group, group.value, corners);
                    if (group.edge || group.on_border)
                        found[k].push_back(std::move(group));
                }
                found[k].shrink_to_fit();
            }
        });
        for (std::vector<CornerGroup>& of_side : found)
            for (CornerGroup& group : std::exchange(of_side, {})) // which frees them side by side
                groups.push_back(std::move(group));
    };
    add(shown.empty() ? std::vector<char>(scene.surfaces().size(), 1) : shown);
    if (!shown.empty())
        add(surfaces_beside(scene, shown, groups, threads));
    join_borders(scene, normals, groups, threads, corners);
    interpolate_hanging_nodes(groups, corners);
    return corners;
}

} // namespace

SmoothShading::SmoothShading(const Scene& scene, const std::vector<Rgb>& values, int threads,
                             const std::vector<char>& shown)
    : scene_(scene)
{
    const VisiblePatches patches(scene, values, threads);
    corners_ = corner_values(patches, patch_slopes(patches, threads), threads, shown);
}

std::vector<double> interpolation_errors(const Scene& scene, const std::vector<Rgb>& values, int threads)
{
    const VisiblePatches patches(scene, values, threads);
    std::vector<double> bends;
    const std::vector<PatchSlope> slopes = patch_slopes(patches, threads, &bends);
    const std::vector<Rgb> corners = corner_values(patches, slopes, threads, {});
    // The linear functions of neighbours on a quadratic function agree at the corners, so that only bends show its
    // error. For b x^2 / 2 the mean square error on a patch is b^2 / 720, and bends are b^2 / 2, since the neighbours
    // along y count as 0. The factor 9 matches the other term, a mean square at corners: for a x y it is 9 times that
    // over the patch.
    constexpr double share_of_bends = 9.0 * 2.0 / 720.0;
    std::vector<double> errors(values.size());
    parallel_numbers(scene.patch_count(), threads, [&](std::uint32_t i) {
        const std::size_t count = scene.corners(i).count;
        double sum = 0.0;
        for (std::uint32_t k = 0; k < count; ++k) {
            const Rgb own = patches.value(i) + slopes[i].at_corner(k, count);
            const Rgb difference = corners[CornerLattice::per_cell * i + k] - own;
            sum += mean(difference * difference);
        }
        errors[i] = patches.open_share(i) * (sum / static_cast<double>(count) + share_of_bends * bends[i]);
    });
    return errors;
}

Rgb SmoothShading::at(const Hit& hit) const
{
    const std::size_t first_patch = scene_.first_patch(hit.surface, hit.front);
    return CornerLattice(scene_.tessellation(hit.surface))
        .interpolated(&corners_[CornerLattice::per_cell * first_patch], hit.u, hit.v);
}

std::array<Rgb, 4> SmoothShading::at_corners(std::uint32_t patch) const
{
    std::array<Rgb, 4> result;
    for (std::size_t k = 0; k < scene_.corners(patch).count; ++k)
        result[k] = corners_[CornerLattice::per_cell * patch + k];
    return result;
}

namespace {

/// [W/m^2] The radiosity without the reflected sunlight.
std::vector<Rgb> without_sunlight(const Scene& scene, std::vector<Rgb> radiosity)
{
    if (scene.file().sun)
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            radiosity[i] = radiosity[i] - scene.reflectance(i) * scene.sunlight(i);
    return radiosity;
}

} // namespace

ShownRadiosity::ShownRadiosity(const Scene& scene, const std::vector<Rgb>& radiosity, int threads,
                               const std::vector<char>& shown)
    : scene_(scene), light_(scene, without_texture(scene, without_sunlight(scene, radiosity)), threads, shown)
{
    if (!scene.file().sun)
        return;
    // Red: the share of the sun's irradiance, green: the same without shadows, blue: 1. What SmoothShading does is
    // linear and the same in all channels, so that on a plane green remains a multiple of blue, also beside covered
    // parts.
    std::vector<Rgb> values(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        values[i] = {quotient(mean(scene.sunlight(i)), mean(scene.file().sun->irradiance)),
                     std::max(0.0, dot(scene.patch(i).shape.normal(), scene.file().sun->direction)), 1.0};
    sunlight_.emplace(scene, values, threads, shown);
    has_edge_.resize(values.size());
    parallel_numbers(scene.patch_count(), threads, [&](std::uint32_t i) {
        const auto is_multiple = [](double value, double factor, double of) {
            constexpr double rounding = 1e-9;
            return std::abs(value - factor * of) <= rounding * std::max(1.0, std::abs(of));
        };
        const auto [lit, unshadowed, one] = values[i];
        const std::array<Rgb, 4> corners = sunlight_->at_corners(i);
        bool is_uniform = lit == 0.0 || is_multiple(lit, unshadowed, one);
        for (std::size_t k = 0; k < scene.corners(i).count; ++k) {
            if (!is_multiple(corners[k].g, unshadowed, corners[k].b)) // a curved surface
                return;
            is_uniform = is_uniform && is_multiple(corners[k].r, lit, corners[k].b);
        }
        has_edge_[i] = is_uniform ? 0 : 1;
    });
}

/// [W/m^2] Irradiance by the sun at a hit.
Rgb ShownRadiosity::sunlight(const Hit& hit) const
{
    if (!sunlight_)
        return {};
    if (has_edge_[scene_.patch_at(hit.surface, hit.u, hit.v, hit.front)] == 0)
        return sunlight_->at(hit).r * scene_.file().sun->irradiance;
    const Surface& surface = scene_.surfaces()[hit.surface];
    return scene_.sunlight(hit.surface, surface.at(hit.u, hit.v), hit.front ? surface.normal() : -surface.normal());
}

Rgb ShownRadiosity::at(const Hit& hit) const
{
    const Rgb plain = light_.at(hit);
    const Material& material = scene_.surface_material(hit.surface);
    if (scene_.file().textures.empty() || !scene_.is_textured(hit.surface))
        return plain + material.reflectance * sunlight(hit);
    const Rgb emitted = hit.front ? material.emittance : Rgb{};
    const Rgb light = light_on(plain - emitted, material.reflectance) + sunlight(hit);
    return emitted + scene_.reflectance_at(hit.surface, hit.u, hit.v) * light;
}

} // namespace multipath
