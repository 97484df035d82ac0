#pragma once

#include "geometry/vec3.h"

#include <limits>

namespace multipath {

/// The points origin + t * direction with 0 <= t <= t_max. A chord has t_max = 1; a ray has t_max = infinity.
/// A direction of length zero is allowed and meets nothing.
struct Line
{
    Vec3 origin;
    Vec3 direction;
    double t_max = std::numeric_limits<double>::infinity();

    Vec3 at(double t) const { return origin + t * direction; }
};

inline Line chord(Vec3 from, Vec3 to)
{
    return {from, to - from, 1.0};
}

} // namespace multipath
