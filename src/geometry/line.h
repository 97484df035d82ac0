#pragma once

#include "geometry/vec3.h"

#include <limits>

namespace multipath {

/// The points origin + t * direction with 0 <= t <= t_max: t_max = 1 for a chord, infinity for a ray. A direction of
/// length zero is allowed; such a line meets nothing.
struct Line
{
    Vec3 origin;
    Vec3 direction;
    double t_max = std::numeric_limits<double>::infinity();

    Vec3 at(double t) const { return origin + t * direction; }
};

/// The segment between two points.
inline Line chord(Vec3 from, Vec3 to)
{
    return {from, to - from, 1.0};
}

} // namespace multipath
