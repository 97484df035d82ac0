// Each surface first gets values at the corners of its own patches (CornerGroup). Then corners of different surfaces
// that coincide are joined: the triangles of a sphere and the rectangles of a ceiling become one smooth skin, while an
// edge of a box, or of another material, stays sharp.

#include "image/smooth_shading.h"

#include "image/corner_groups.h"
#include "image/corner_lattice.h"
#include "image/skin.h"
#include "image/visible_patches.h"
#include "sampling/random.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace multipath {

namespace {

constexpr std::size_t most_joined = 1000; // a hub of more surfaces stays unjoined, to bound the work

/// A group that may coincide with groups of other surfaces.
struct BorderGroup
{
    std::uint64_t key = 0; ///< equal for coinciding corners on the same kind of side
    CornerGroup group;
};

bool is_source(const Scene& scene, std::uint32_t surface)
{
    return scene.surface_material(surface).emittance != Rgb{};
}

/// Names a point to within a millionth of the scene, on a grid that is shifted so that round numbers fall inside cells.
std::uint64_t corner_key(const Scene& scene, Vec3 point, std::uint64_t kind)
{
    const double cell = 1e-6 * scene.bounds().diagonal();
    const Vec3 from_low = point - scene.bounds().low;
    std::uint64_t key = mix_bits(kind);
    for (const double x : {from_low.x, from_low.y, from_low.z})
        key = mix_bits(key ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / cell + 0.382))));
    return key;
}

/// Is there a free way from one to the other?
bool joins(const Scene& scene, const CornerGroup& a, const CornerGroup& b)
{
    if (!level(a.normal, b.normal))
        return false;
    for (const OpenPoint& from : a.points)
        for (const OpenPoint& to : b.points)
            if (!parted(scene, from, to))
                return true;
    return false;
}

/// Groups at one place: the value of each becomes the mean of those that it joins.
template <class Put>
void join_place(const Scene& scene, const BorderGroup* first, const BorderGroup* last, const Put& put)
{
    for (const BorderGroup* own = first; own != last; ++own) {
        Rgb sum;
        double weight = 0.0;
        for (const BorderGroup* other = first; other != last; ++other)
            if (other != own && other->group.surface != own->group.surface && joins(scene, own->group, other->group)) {
                sum += other->group.weight * other->group.value;
                weight += other->group.weight;
            }
        if (weight > 0.0)
            put(own->group, 1.0 / (own->group.weight + weight) * (sum + own->group.weight * own->group.value));
    }
}

template <class Put>
void join_borders(const Scene& scene, std::vector<BorderGroup> borders, const Put& put)
{
    // The corner's number decides among equals, so that sums do not depend on the sorting algorithm.
    std::sort(borders.begin(), borders.end(), [](const BorderGroup& a, const BorderGroup& b) {
        return a.key < b.key || (a.key == b.key && a.group.places.front() < b.group.places.front());
    });
    const BorderGroup* const end = borders.data() + borders.size();
    for (const BorderGroup* first = borders.data(); first != end;) {
        const BorderGroup* last =
            std::find_if(first, end, [&](const BorderGroup& other) { return other.key != first->key; });
        const auto count = static_cast<std::size_t>(last - first);
        if (count > 1 && count <= most_joined)
            join_place(scene, first, last, put);
        first = last;
    }
}

} // namespace

SmoothShading::SmoothShading(const Scene& scene, const std::vector<Rgb>& values_per_patch, int threads)
    : scene_(scene), values_(values_per_patch), corners_(CornerLattice::per_cell * values_per_patch.size())
{
    const auto put = [this](const CornerGroup& group, Rgb value) {
        for (const std::size_t place : group.places)
            corners_[place] = value;
    };
    const VisiblePatches patches(scene, values_per_patch, threads);
    std::vector<BorderGroup> borders;
    for (const bool front : {true, false})
        for (std::uint32_t surface = 0; surface < scene.surfaces().size(); ++surface) {
            if (is_source(scene, surface) || !(front || scene.two_sided()))
                continue;
            const std::uint64_t kind = 2 * std::uint64_t{scene.file().material[surface]} + (front ? 1 : 0);
            for (CornerGroup& group : corner_groups(patches, surface, front)) {
                put(group, group.value);
                if (group.on_border)
                    borders.push_back({corner_key(scene, group.corner, kind), std::move(group)});
            }
        }
    join_borders(scene, std::move(borders), put);
}

Rgb SmoothShading::at(const Hit& hit) const
{
    const std::uint32_t patch = scene_.patch_at(hit.surface, hit.u, hit.v, hit.front);
    if (is_source(scene_, hit.surface))
        return values_[patch];
    const std::size_t first_patch = scene_.first_patch(hit.surface, hit.front);
    return CornerLattice(scene_.tessellation(hit.surface))
        .interpolated(&corners_[CornerLattice::per_cell * first_patch], hit.u, hit.v);
}

std::array<Rgb, 4> SmoothShading::at_corners(std::uint32_t patch) const
{
    std::array<Rgb, 4> result;
    result.fill(values_[patch]);
    if (is_source(scene_, scene_.surface_of(patch)))
        return result;
    for (std::size_t k = 0; k < scene_.corners(patch).count; ++k)
        result[k] = corners_[CornerLattice::per_cell * patch + k];
    return result;
}

} // namespace multipath
