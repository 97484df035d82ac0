#pragma once

#include "geometry/bounds.h"
#include "geometry/surface.h"
#include "parallel/memory.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// The points p with dot(normal, p) = offset. The unit normal points to the front of its surface.
struct Plane
{
    Vec3 normal;
    double offset = 0.0;
};

/// What counts as lying in a plane, as a share of the scene's diagonal: what six-digit coordinates can mean.
constexpr double coplanar_distance = 5e-6;

/// Coplanar surfaces, in numbers that differ by rounding, brought onto one plane: a line meets all of them at exactly
/// the same t. (Reversing a plane changes the sign of both sides of the division that gives t, which is exact.)
struct SharedPlanes
{
    LargeVector<Plane> plane_of_surface;     ///< facing as the surface does
    std::vector<std::uint32_t> plane_number; ///< per surface; equal for surfaces in one plane, whichever way they face
};

/// Surfaces whose corners all lie within coplanar_distance of a larger surface's plane get its number. They get its
/// equation too if some of them face the other way: only those can touch each other. A mesh that bends a little keeps
/// its own planes, so that its triangles meet at their edges. `order`: see from_large_to_small.
SharedPlanes share_planes(const SurfaceList& surfaces, const std::vector<std::uint32_t>& order);

} // namespace multipath
