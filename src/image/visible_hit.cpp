#include "image/visible_hit.h"

#include <algorithm>
#include <vector>

namespace multipath {

std::optional<Hit> visible_hit(const Scene& scene, const Line& ray)
{
    const std::optional<Hit> nearest = scene.intersector().closest_hit(ray);
    if (!nearest || nearest->front || scene.two_sided())
        return nearest;
    std::vector<Hit> hits;
    scene.intersector().all_hits(ray, hits);
    const auto first = std::find_if(hits.begin(), hits.end(), [](const Hit& hit) { return hit.front; });
    return first == hits.end() ? std::nullopt : std::optional<Hit>(*first);
}

} // namespace multipath
