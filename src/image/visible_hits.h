#pragma once

#include "geometry/intersector.h"
#include "geometry/line.h"
#include "scene/scene.h"

#include <optional>
#include <vector>

namespace multipath {

/// Finds the first side that exists along a ray: the backs of one-sided surfaces are looked through, so that a closed
/// room can be seen from outside. Fastest for rays in the order of a picture; to be used by one thread.
class VisibleHits
{
public:
    explicit VisibleHits(const Scene& scene) : scene_(scene) {}

    std::optional<Hit> first(const Line& ray);

private:
    std::optional<Hit> first_front(const Line& ray);

    const Scene& scene_;
    bool passed_back_ = false; ///< by the last ray, so probably by the next
    std::vector<Hit> hits_;    ///< kept for its memory
};

} // namespace multipath
