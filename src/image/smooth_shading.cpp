// Each surface first gets values at the corners of its own patches (CornerLattice). Then corners of different surfaces
// that coincide are joined: the triangles of a sphere and the rectangles of a ceiling become one smooth skin, while an
// edge of a box, or of another material, stays sharp.

#include "image/smooth_shading.h"

#include "image/corner_lattice.h"
#include "sampling/random.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

constexpr double smallest_cosine = 0.8660254037844386; // 30 degrees: more is a crease
constexpr std::size_t most_joined = 1000;              // a hub of more surfaces stays unjoined, to bound the work

/// A corner that may coincide with corners of other surfaces.
struct BorderCorner
{
    std::uint64_t place = 0; ///< equal for coinciding corners on the same kind of side
    std::size_t corner = 0;  ///< number among all corners
    std::uint32_t surface = 0;
    std::uint32_t weight = 0; ///< number of patches behind the corner's value
};

bool is_source(const Scene& scene, std::uint32_t surface)
{
    return scene.materials()[scene.file().material[surface]].emittance != Rgb{};
}

/// Names a point to within a millionth of the scene, on a grid that is shifted so that round numbers fall inside cells.
std::uint64_t place_of(const Scene& scene, Vec3 point, std::uint64_t kind)
{
    const double cell = 1e-6 * scene.bounds().diagonal();
    const Vec3 from_low = point - scene.bounds().low;
    std::uint64_t place = mix_bits(kind);
    for (const double x : {from_low.x, from_low.y, from_low.z})
        place = mix_bits(place ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / cell + 0.382))));
    return place;
}

/// The border corners of one side of one surface.
void append_border(const Scene& scene, std::uint32_t surface, bool front, std::size_t first_corner,
                   std::vector<BorderCorner>& borders)
{
    const CornerLattice lattice(scene.tessellation(surface));
    const std::uint64_t kind = 2 * std::uint64_t{scene.file().material[surface]} + (front ? 1 : 0);
    for (std::uint32_t j = 0; j <= lattice.last_row(); ++j)
        for (std::uint32_t i = 0; i <= lattice.last_column(j); ++i)
            if (lattice.on_border(i, j)) {
                const Vec3 point = scene.surfaces()[surface].at(lattice.u(i), lattice.v(j));
                borders.push_back({place_of(scene, point, kind), first_corner + lattice.number(i, j), surface,
                                   lattice.cells_at(i, j)});
            }
}

/// Corners at one place: each becomes the mean of those that are not across a crease.
void join_group(const std::vector<Vec3>& normals, const BorderCorner* first, const BorderCorner* last,
                const std::vector<Rgb>& separate, std::vector<Rgb>& joined)
{
    for (const BorderCorner* corner = first; corner != last; ++corner) {
        Rgb sum;
        double weight = 0.0;
        for (const BorderCorner* other = first; other != last; ++other)
            if (dot(normals[corner->surface], normals[other->surface]) >= smallest_cosine) {
                sum += static_cast<double>(other->weight) * separate[other->corner];
                weight += other->weight;
            }
        joined[corner->corner] = (1.0 / weight) * sum;
    }
}

std::vector<Rgb> joined_corners(const Scene& scene, std::vector<BorderCorner> borders, const std::vector<Rgb>& separate)
{
    std::vector<Vec3> normals;
    for (const Surface& surface : scene.surfaces())
        normals.push_back(surface.normal());
    // The corner's number decides among equals, so that sums do not depend on the sorting algorithm.
    std::sort(borders.begin(), borders.end(), [](const BorderCorner& a, const BorderCorner& b) {
        return a.place < b.place || (a.place == b.place && a.corner < b.corner);
    });
    std::vector<Rgb> joined = separate;
    const BorderCorner* const end = borders.data() + borders.size();
    for (const BorderCorner* first = borders.data(); first != end;) {
        const BorderCorner* last =
            std::find_if(first, end, [&](const BorderCorner& corner) { return corner.place != first->place; });
        const auto count = static_cast<std::size_t>(last - first);
        if (count > 1 && count <= most_joined)
            join_group(normals, first, last, separate, joined);
        first = last;
    }
    return joined;
}

} // namespace

SmoothShading::SmoothShading(const Scene& scene, const std::vector<Rgb>& values_per_patch)
    : scene_(scene), values_(values_per_patch)
{
    const auto surface_count = static_cast<std::uint32_t>(scene.surfaces().size());
    std::vector<BorderCorner> borders;
    for (const bool front : {true, false})
        for (std::uint32_t surface = 0; surface < surface_count; ++surface) {
            first_corner_.push_back(corners_.size());
            if (is_source(scene, surface) || !(front || scene.two_sided()))
                continue;
            append_border(scene, surface, front, corners_.size(), borders);
            const std::vector<Rgb> corners =
                CornerLattice(scene.tessellation(surface)).corner_values([&](double u, double v) {
                    return values_[scene.patch_at(surface, u, v, front)];
                });
            corners_.insert(corners_.end(), corners.begin(), corners.end());
        }
    corners_ = joined_corners(scene, std::move(borders), corners_);
}

Rgb SmoothShading::at(const Hit& hit) const
{
    if (is_source(scene_, hit.surface))
        return values_[scene_.patch_at(hit.surface, hit.u, hit.v, hit.front)];
    const Rgb* corners = &corners_[first_corner(hit.surface, hit.front)];
    return CornerLattice(scene_.tessellation(hit.surface)).interpolated(corners, hit.u, hit.v);
}

std::array<Rgb, 4> SmoothShading::at_corners(std::uint32_t patch) const
{
    std::array<Rgb, 4> result;
    result.fill(values_[patch]);
    const std::uint32_t surface = scene_.surface_of(patch);
    if (is_source(scene_, surface))
        return result;
    const CornerLattice lattice(scene_.tessellation(surface));
    const CellCorners corners = scene_.corners(patch);
    for (std::size_t k = 0; k < corners.count; ++k)
        result[k] = corners_[first_corner(surface, scene_.is_front(patch)) +
                             lattice.number(corners.points[k].i, corners.points[k].j)];
    return result;
}

std::size_t SmoothShading::first_corner(std::uint32_t surface, bool front) const
{
    return first_corner_[front ? surface : scene_.surfaces().size() + surface];
}

} // namespace multipath
