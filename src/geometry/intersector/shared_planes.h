#pragma once

#include "base/memory.h"
#include "geometry/surface.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// The points p with dot(normal, p) = offset [scene units]. The plane of a surface has its unit normal on the front
/// side.
struct Plane
{
    Vec3 normal;
    double offset = 0.0;
};

/// Largest distance from a plane at which a corner counts as in the plane, as a share of the scene's diagonal: the
/// rounding of coordinates with six digits.
constexpr double coplanar_distance = 5e-6;

/// Common planes for surfaces that are coplanar up to rounding. Coplanar surfaces have the same plane number. If some
/// of them face opposite ways, they also have the same equation, up to its sign, so that a line meets all of them at
/// exactly the same t. (Reversing a plane negates numerator and denominator of t, which is exact.)
struct SharedPlanes
{
    LargeVector<Plane> plane_of_surface;     ///< per surface; the normal points to its front
    std::vector<std::uint32_t> plane_number; ///< per surface; equal for surfaces in one plane, of either orientation
};

/// Takes the surfaces from large to small, in the `order` of order_by_descending_area. A surface whose corners all lie
/// within coplanar_distance of an almost parallel plane found before gets the number of that plane; else it starts a
/// new plane. The surface gets the equation of the plane as well if the plane has surfaces of both orientations: only
/// those can touch face to face. The triangles of a slightly curved mesh keep their own equations, so that they meet at
/// their edges.
SharedPlanes share_planes(const SurfaceList& surfaces, const std::vector<std::uint32_t>& order);

} // namespace multipath
