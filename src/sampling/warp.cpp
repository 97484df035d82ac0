#include "sampling/warp.h"

#include "sampling/trigonometry.h"

#include <cmath>

namespace multipath {

Vec3 square_to_uniform_sphere(double a, double b)
{
    const double z = 1.0 - 2.0 * a;
    const double radius = 2.0 * std::sqrt(a * (1.0 - a)); // = sqrt(1 - z^2) without its cancellation
    const SinCos angle = sin_cos_of_turns(b);
    return {radius * angle.cos, radius * angle.sin, z};
}

Vec3 square_to_cosine_hemisphere(double a, double b)
{
    // Uniform on the disc below the hemisphere (Malley): its height above the disc carries the cosine.
    const double radius = std::sqrt(a);
    const SinCos angle = sin_cos_of_turns(b);
    return {radius * angle.cos, radius * angle.sin, std::sqrt(1.0 - a)};
}

Barycentric square_to_uniform_triangle(double a, double b)
{
    const double width = std::sqrt(1.0 - a); // of the triangle at u = 1 - width, whose mass beyond it is width^2
    return {1.0 - width, b * width};
}

} // namespace multipath
