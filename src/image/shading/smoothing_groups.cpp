// Occlusion between two points of a surface is tested with a segment that is lifted above the surface by a small share
// of its length, so that it meets what stands on the surface but not the surface itself.

#include "image/shading/smoothing_groups.h"

#include "geometry/bounds.h"
#include "geometry/intersector/intersector.h"
#include "sampling/random.h"

#include <algorithm>
#include <cmath>

namespace multipath {

bool same_smoothing_group(Vec3 a, Vec3 b)
{
    constexpr double smallest_cosine = 0.8660254037844386; // of 30 degrees; a larger angle is a crease
    return dot(a, b) >= smallest_cosine;
}

namespace {

constexpr double lift = 0.01;     // share of the distance: more than rounding errors, less than any object
constexpr double rounding = 1e-9; // share of the scene's diagonal

/// The lifted segment between two points.
Line lifted_segment(const OpenPoint& a, const OpenPoint& b)
{
    const double height = lift * length(b.point - a.point);
    return chord(a.point + height * a.normal, b.point + height * b.normal);
}

/// True if a surface with this normal belongs to the smoothing group of neither point.
bool may_occlude(Vec3 normal, const OpenPoint& a, const OpenPoint& b)
{
    return !same_smoothing_group(normal, a.normal) && !same_smoothing_group(normal, b.normal);
}

} // namespace

std::uint64_t position_hash(const Scene& scene, Vec3 point, std::uint64_t kind)
{
    // The grid is shifted so that round coordinates fall inside cells, not on their borders.
    const double cell = 1e-6 * scene.bounds().diagonal();
    const Vec3 from_low = point - scene.bounds().low;
    std::uint64_t key = mix_bits(kind);
    for (const double x : {from_low.x, from_low.y, from_low.z})
        key = mix_bits(key ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / cell + 0.382))));
    return key;
}

bool occluded_between(const Scene& scene, const OpenPoint& a, const OpenPoint& b)
{
    std::vector<Hit> hits;
    scene.intersector().all_hits(lifted_segment(a, b), hits);
    return std::any_of(hits.begin(), hits.end(),
                       [&](const Hit& hit) { return may_occlude(scene.surfaces()[hit.surface].normal(), a, b); });
}

NearbyOccluders::NearbyOccluders(const Scene& scene, const std::vector<Vec3>& normals,
                                 const std::vector<OpenPoint>& points)
    : scene_(scene)
{
    Bounds box;
    for (const OpenPoint& point : points)
        box.include(point.point);
    const double play = rounding * scene.bounds().diagonal();
    const double reach = 2.0 * lift * box.diagonal() + play;
    const auto grown = [](const Bounds& bounds, double by) {
        return Bounds{bounds.low - Vec3{by, by, by}, bounds.high + Vec3{by, by, by}};
    };
    box = grown(box, reach);
    for (const std::uint32_t surface : scene.intersector().surfaces_near(box)) {
        const bool is_level = std::all_of(points.begin(), points.end(), [&](const OpenPoint& point) {
            return same_smoothing_group(normals[surface], point.normal);
        });
        if (is_level)
            continue;
        const Bounds own = scene.surfaces()[surface].bounds();
        if (overlap(own, box))
            near_.push_back({surface, normals[surface], grown(own, play)});
    }
}

bool NearbyOccluders::separate(const OpenPoint& a, const OpenPoint& b) const
{
    const Line line = lifted_segment(a, b);
    Bounds box;
    box.include(line.origin);
    box.include(line.origin + line.direction);
    return std::any_of(near_.begin(), near_.end(), [&](const Near& near) {
        return overlap(box, near.box) && may_occlude(near.normal, a, b) &&
               scene_.intersector().hit_on(line, near.surface);
    });
}

} // namespace multipath
