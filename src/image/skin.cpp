#include "image/skin.h"

#include <algorithm>
#include <vector>

namespace multipath {

bool level(Vec3 a, Vec3 b)
{
    constexpr double smallest_cosine = 0.8660254037844386; // 30 degrees: more is a crease
    return dot(a, b) >= smallest_cosine;
}

bool parted(const Scene& scene, const OpenPoint& a, const OpenPoint& b)
{
    const double lift = 0.01 * length(b.point - a.point); // what touches the surface is met, its own rounding is not
    std::vector<Hit> hits;
    scene.intersector().all_hits(chord(a.point + lift * a.normal, b.point + lift * b.normal), hits);
    return std::any_of(hits.begin(), hits.end(), [&](const Hit& hit) {
        const Vec3 normal = scene.surfaces()[hit.surface].normal();
        return !level(normal, a.normal) && !level(normal, b.normal);
    });
}

} // namespace multipath
