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

/// Largest distance from a plane that counts as in it, as a share of the scene's diagonal: the rounding of coordinates
/// with six digits.
constexpr double coplanar_distance = 5e-6;

/// One common plane for surfaces that are coplanar up to rounding, so that a line meets all of them at exactly the same
/// t. (Reversing a plane negates numerator and denominator of t, which is exact.)
struct SharedPlanes
{
    LargeVector<Plane> plane_of_surface;     ///< with the orientation of the surface
    std::vector<std::uint32_t> plane_number; ///< per surface; equal for surfaces in one plane, of either orientation
};

/// Surfaces whose corners all lie within coplanar_distance of a larger surface's plane get its number. They get its
/// equation as well if the plane has surfaces of both orientations: only those can touch face to face. A slightly
/// curved mesh keeps its own planes, so that its triangles meet at their edges. `order`: see order_by_descending_area.
SharedPlanes share_planes(const SurfaceList& surfaces, const std::vector<std::uint32_t>& order);

} // namespace multipath
