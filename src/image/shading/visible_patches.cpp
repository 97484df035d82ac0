// A sample point is covered if rays in five directions all end at once at a coincident surface, or at the back of a
// one-sided surface, which is the inside of a solid. The first direction, along the normal, decides for most points, so
// that only the rest is traced in the other directions.

#include "image/shading/visible_patches.h"

#include "geometry/polygon.h"
#include "image/ray_fan.h"
#include "image/shading/smoothing_groups.h"
#include "parallel/blocks.h"
#include "scene/tessellation.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <limits>
#include <numeric>

namespace multipath {

namespace {

constexpr std::uint8_t most_along = 8;          // 8 x 8 points, one bit each in a 64-bit word
constexpr std::uint64_t most_points = 1u << 21; // of all touched patches, approximately; bounds the time

/// Sample point: the centre of one of along * along equal parts of the patch.
Vec3 sample_point(const Surface& shape, std::uint32_t along, std::uint32_t number)
{
    if (shape.shape == Shape::parallelogram) {
        const std::uint32_t row = number / along;
        return shape.at((row + 0.5) / along, (number % along + 0.5) / along);
    }
    return Tessellation{shape.shape, along, along, nullptr}.cell(shape, number).centre();
}

/// True if a ray with this first hit starts below a coincident surface or inside a solid.
bool is_closed_in(const Scene& scene, const Hit& hit)
{
    return hit.t <= 1e-9 * scene.bounds().diagonal() || (!hit.front && !scene.two_sided());
}

/// The test directions: the normal, and four oblique ones around it.
std::array<Vec3, 5> test_directions(const Surface& shape)
{
    const Vec3 normal = shape.normal();
    const Vec3 aside = normalized(shape.edge_u);
    const Vec3 along = cross(normal, aside);
    return {normal, normal + 0.6 * aside + 0.8 * along, normal - 0.8 * aside + 0.6 * along,
            normal - 0.6 * aside - 0.8 * along, normal + 0.8 * aside - 0.6 * along};
}

/// True if the interior of the patch touches or meets another surface, or may do so. Otherwise it is open or covered as
/// a whole.
bool is_touched(const Scene& scene, const Patch& patch)
{
    constexpr double border = 1e-6; // share of the edges
    const double gap = 1e-8 * scene.bounds().diagonal();
    const Vec3 centre = patch.shape.centre();
    Bounds box;
    for (const Vec3& corner : corners_of(patch.shape))
        box.include(corner + border * (centre - corner));
    box = {box.low - Vec3{gap, gap, gap}, box.high + Vec3{gap, gap, gap}};
    const std::vector<std::uint32_t> near = scene.intersector().surfaces_near(box);
    return std::any_of(near.begin(), near.end(), [&](std::uint32_t surface) {
        return surface != patch.surface && overlap(box, scene.surfaces()[surface].bounds());
    });
}

/// One bit for each of along * along sample points, set if is_covered() is false there. `fan`: reusable buffers.
std::uint64_t open_points(const Scene& scene, const Patch& patch, std::uint32_t along, RayFan& fan)
{
    std::vector<std::uint32_t> covered(std::size_t{along} * along); // in all directions so far
    std::iota(covered.begin(), covered.end(), 0u);
    for (const Vec3 direction : test_directions(patch.shape)) {
        fan.rays.clear();
        for (const std::uint32_t n : covered)
            fan.rays.push_back({sample_point(patch.shape, along, n), direction});
        const FirstHits& hits = fan.trace(scene, patch.surface);
        std::size_t kept = 0;
        for (std::size_t k = 0; k < covered.size(); ++k)
            if (hits.is_hit(k) && is_closed_in(scene, hits[k]))
                covered[kept++] = covered[k];
        covered.resize(kept);
        if (covered.empty())
            break;
    }
    std::uint64_t open = ~std::uint64_t{0} >> (64 - along * along);
    for (const std::uint32_t n : covered)
        open &= ~(std::uint64_t{1} << n);
    return open;
}

} // namespace

bool is_covered(const Scene& scene, std::uint32_t surface, const Surface& shape, Vec3 point)
{
    const std::array<Vec3, 5> directions = test_directions(shape);
    return std::all_of(directions.begin(), directions.end(), [&](Vec3 direction) {
        const std::optional<Hit> hit = scene.intersector().closest_hit_from(surface, {point, direction});
        return hit && is_closed_in(scene, *hit);
    });
}

VisiblePatches::VisiblePatches(const Scene& scene, const std::vector<Rgb>& values, int threads)
    : scene_(scene), values_(values), along_(scene.patch_count()), open_(scene.patch_count())
{
    std::vector<char> touched(scene.patch_count());
    parallel_numbers(scene.patch_count(), threads,
                     [&](std::uint32_t i) { touched[i] = is_touched(scene, scene.patch(i)) ? 1 : 0; });
    // [1/m^2] Upper bound of the density of sample points among patches that are touched, or are not.
    const auto density_among = [&](char kind) {
        std::uint64_t count = 0;
        double area = 0.0;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            if (touched[i] == kind) {
                ++count;
                area += scene.area(i);
            }
        return count <= most_points / (std::uint64_t{most_along} * most_along)
                   ? std::numeric_limits<double>::infinity()
                   : static_cast<double>(most_points) / area;
    };
    const std::array<double, 2> density = {density_among(0), density_among(1)};
    constexpr std::uint32_t patches_at_a_time = 64;
    parallel_ranges(scene.patch_count(), patches_at_a_time, threads, [&](std::uint32_t first, std::uint32_t end) {
        RayFan fan;
        for (std::uint32_t i = first; i < end; ++i) {
            const bool is_whole = touched[i] == 0; // one point decides
            const double points = density[is_whole ? 0 : 1] * scene.area(i);
            std::uint8_t& along = along_[i];
            for (along = most_along; along > 1 && along * along > points;)
                along /= 2;
            const std::uint64_t all = ~std::uint64_t{0} >> (64 - along * along);
            if (is_whole)
                open_[i] = open_points(scene, scene.patch(i), 1, fan) != 0 ? all : 0;
            else // a single point would not do: all or nothing would be covered
                open_[i] = along > 1 ? open_points(scene, scene.patch(i), along, fan) : all;
        }
    });
}

double VisiblePatches::open_share(std::uint32_t patch) const
{
    const std::uint32_t along = along_[patch];
    return static_cast<double>(std::bitset<64>(open_[patch]).count()) / (along * along);
}

Rgb VisiblePatches::value(std::uint32_t patch) const
{
    const double share = open_share(patch);
    const bool shines = scene_.emittance(patch) != Rgb{};
    return share > 0.0 && !shines ? 1.0 / share * values_[patch] : values_[patch];
}

std::optional<Vec3> VisiblePatches::open_point_near(std::uint32_t patch, Vec3 corner) const
{
    const Surface shape = scene_.patch(patch).shape;
    const std::uint32_t along = along_[patch];
    const std::uint64_t all = ~std::uint64_t{0} >> (64 - along * along);
    if (open_[patch] == all && shape.shape == Shape::parallelogram && dot(shape.edge_u, shape.edge_v) == 0.0) {
        const auto nearest_along = [&](Vec3 edge) {
            const double share = dot(corner - shape.origin, edge) / dot(edge, edge);
            return (std::floor(std::clamp(share * along, 0.0, along - 1.0)) + 0.5) / along;
        };
        return shape.at(nearest_along(shape.edge_u), nearest_along(shape.edge_v));
    }
    double nearest = std::numeric_limits<double>::infinity();
    std::optional<Vec3> result;
    for (std::uint32_t n = 0; n < along * along; ++n) {
        const Vec3 point = sample_point(shape, along, n);
        const double distance = length(point - corner);
        if ((open_[patch] >> n & 1u) != 0 && distance < nearest) {
            nearest = distance;
            result = point;
        }
    }
    return result;
}

bool VisiblePatches::are_joined(std::uint32_t a, std::uint32_t b) const
{
    const Surface shape = scene_.patch(a).shape;
    const Vec3 middle = 0.5 * (shape.centre() + scene_.patch(b).shape.centre());
    const std::optional<Vec3> from = open_point_near(a, middle);
    const std::optional<Vec3> to = open_point_near(b, middle);
    return from && to && !occluded_between(scene_, {*from, shape.normal()}, {*to, shape.normal()});
}

} // namespace multipath
