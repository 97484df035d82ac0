#pragma once

#include "geometry/vec3.h"

#include <limits>

namespace multipath {

/// The points origin + t * direction with 0 <= t <= t_max: t_max = 1 for a chord, infinity for a ray. The direction may
/// have any length, so t is a parameter and not a distance. A line whose direction has length zero meets no surface.
struct Line
{
    Vec3 origin;
    Vec3 direction;
    double t_max = std::numeric_limits<double>::infinity();

    Vec3 at(double t) const { return origin + t * direction; }
};

/// The segment between two points: t = 0 at `from`, t = 1 at `to`.
inline Line chord(Vec3 from, Vec3 to)
{
    return {from, to - from, 1.0};
}

} // namespace multipath
