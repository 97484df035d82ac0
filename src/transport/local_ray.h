#pragma once

#include "geometry/line.h"
#include "sampling/sequence.h"
#include "scene/scene.h"

#include <cstdint>

namespace multipath {

/// The rays that leave one patch.
class LocalRays
{
public:
    explicit LocalRays(const Patch& patch);

    /// The ray from a uniform point (item[0], item[1]) in a cosine-distributed direction (item[2], item[3]).
    Line line(const Item& item) const;

private:
    Surface shape_;
    Vec3 tangent_;
    Vec3 bitangent_;
    Vec3 normal_;
};

/// The same for a single ray.
Line local_line(const Patch& patch, const Item& item);

/// Where the ray from a patch arrives: a patch, or Segment::behind or Segment::outside.
std::uint32_t receiver(const Scene& scene, std::uint32_t surface, const Line& ray);

} // namespace multipath
