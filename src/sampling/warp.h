#pragma once

#include "geometry/vec3.h"

namespace multipath {

// Maps from the unit square, each with a density that does not vary over its target.

/// Uniform on the unit sphere: z is uniform (Archimedes), density 1 / (4 pi).
Vec3 square_to_uniform_sphere(double a, double b);

/// Direction about +z with density cos(theta) / pi: the share of the light that a diffuse surface sends there.
Vec3 square_to_cosine_hemisphere(double a, double b);

/// Barycentric coordinates of a point of a triangle.
struct Barycentric
{
    double u;
    double v;
};

/// Uniform on the triangle u, v >= 0, u + v <= 1, density 2. Continuous, so it keeps well-spread points well spread.
Barycentric square_to_uniform_triangle(double a, double b);

} // namespace multipath
