#include "image/visible_hits.h"

#include <algorithm>

namespace multipath {

std::optional<Hit> VisibleHits::first(const Line& ray)
{
    if (passed_back_)
        return first_front(ray);
    const std::optional<Hit> nearest = scene_.intersector().closest_hit(ray);
    if (!nearest || nearest->front || scene_.two_sided())
        return nearest;
    return first_front(ray);
}

std::optional<Hit> VisibleHits::first_front(const Line& ray)
{
    scene_.intersector().all_hits(ray, hits_);
    passed_back_ = !hits_.empty() && !hits_.front().front;
    const auto front = std::find_if(hits_.begin(), hits_.end(), [](const Hit& hit) { return hit.front; });
    return front == hits_.end() ? std::nullopt : std::optional<Hit>(*front);
}

} // namespace multipath
