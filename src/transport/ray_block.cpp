#include "transport/ray_block.h"

#include "transport/intersection_list.h"
#include "transport/local_ray.h"

namespace multipath {

void RayBlock::trace(const Scene& scene)
{
    const std::size_t count = patches.size();
    surfaces_.resize(count);
    for (std::size_t k = 0; k < count; ++k)
        surfaces_[k] = scene.surface_of(patches[k]);
    lines_.resize(count);
    local_lines(scene, patches.data(), items.data(), count, lines_.data());
    scene.intersector().closest_hits_from(surfaces_.data(), lines_.data(), count, hits_);
    receivers.resize(count);
    for (std::size_t k = 0; k < count; ++k)
        receivers[k] = hits_.is_hit(k) ? receiving_patch(scene, hits_[k]) : Segment::outside;
}

} // namespace multipath
