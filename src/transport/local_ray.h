#pragma once

#include "geometry/line.h"
#include "sampling/sequence.h"
#include "scene/scene.h"

#include <cstdint>

namespace multipath {

/// The ray that leaves a patch from a uniform point (item[0], item[1]) in a cosine-distributed direction (item[2],
/// item[3]).
Line local_line(const Patch& patch, const Item& item);

/// Where the ray from a patch arrives: a patch, or Segment::behind or Segment::outside.
std::uint32_t receiver(const Scene& scene, std::uint32_t surface, const Line& ray);

} // namespace multipath
