// Occlusion between two points of a surface is tested with a segment that is lifted above the surface by a small share
// of its length, so that it meets what stands on the surface but not the surface itself.

#include "image/shading/smoothing_groups.h"

#include "geometry/intersector/intersector.h"
#include "sampling/random.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace multipath {

bool same_smoothing_group(Vec3 a, Vec3 b)
{
    constexpr double smallest_cosine = 0.8660254037844386; // of 30 degrees; a larger angle is a crease
    return dot(a, b) >= smallest_cosine;
}

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
    constexpr double lift = 0.01; // share of the distance: more than rounding errors, less than any object
    const double height = lift * length(b.point - a.point);
    std::vector<Hit> hits;
    scene.intersector().all_hits(chord(a.point + height * a.normal, b.point + height * b.normal), hits);
    return std::any_of(hits.begin(), hits.end(), [&](const Hit& hit) {
        const Vec3 normal = scene.surfaces()[hit.surface].normal();
        return !same_smoothing_group(normal, a.normal) && !same_smoothing_group(normal, b.normal);
    });
}

} // namespace multipath
