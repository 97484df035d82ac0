#pragma once

#include "geometry/surface.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// The points p with dot(normal, p) = offset. The unit normal points to the front of its surface.
struct Plane
{
    Vec3 normal;
    double offset = 0.0;
};

/// Coplanar surfaces, in numbers that differ by rounding, brought onto one plane: a line meets all of them at exactly
/// the same t. (Reversing a plane changes the sign of both sides of the division that gives t, which is exact.)
struct SharedPlanes
{
    std::vector<Plane> plane_of_surface;     ///< facing as the surface does
    std::vector<std::uint32_t> plane_number; ///< per surface; equal for surfaces in one plane, whichever way they face
    std::vector<bool> has_two_sides;         ///< per plane number: its surfaces do not all face the same way
};

/// Surfaces whose corners all lie within 1e-6 of the scene's diagonal of a plane met before join that plane.
SharedPlanes share_planes(const std::vector<Surface>& surfaces);

} // namespace multipath
