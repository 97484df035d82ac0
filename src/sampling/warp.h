#pragma once

#include "base/elementary.h"
#include "geometry/surface.h"
#include "geometry/vec3.h"

#include <cmath>

namespace multipath {

// Maps of uniform points (a, b) of the unit square [0, 1)^2 to points and directions of a given density.

/// Uniform point of the unit sphere, density 1 / (4 pi) per solid angle. By Archimedes' theorem z is uniform.
inline Vec3 square_to_uniform_sphere(double a, double b)
{
    const double radius = 2.0 * std::sqrt(a * (1.0 - a)); // = sqrt(1 - z^2) without its cancellation
    const SinCos angle = sin_cos_of_turns(b);
    return {radius * angle.cos, radius * angle.sin, 1.0 - 2.0 * a};
}

/// Direction about +z with density cos(theta) / pi per solid angle, where theta is its angle with +z: the distribution
/// of the light that a diffuse surface emits. Malley's method: a uniform point of the unit disc, projected up to the
/// hemisphere.
inline Vec3 square_to_cosine_hemisphere(double a, double b)
{
    const double radius = std::sqrt(a);
    const SinCos angle = sin_cos_of_turns(b);
    return {radius * angle.cos, radius * angle.sin, std::sqrt(1.0 - a)};
}

/// Coordinates of a point of a surface: the point is the origin + u * edge_u + v * edge_v.
struct SurfacePoint
{
    double u;
    double v;
};

/// Uniform point of the triangle u, v >= 0, u + v <= 1, density 2. The map is continuous, so low-discrepancy points
/// stay well spread.
SurfacePoint square_to_uniform_triangle(double a, double b);

/// Uniform point of a surface of this shape.
inline SurfacePoint square_to_uniform_shape(Shape shape, double a, double b)
{
    return shape == Shape::parallelogram ? SurfacePoint{a, b} : square_to_uniform_triangle(a, b);
}

/// The same as a point of space, density 1 / area.
inline Vec3 square_to_uniform_surface(const Surface& surface, double a, double b)
{
    const SurfacePoint point = square_to_uniform_shape(surface.shape, a, b);
    return surface.at(point.u, point.v);
}

/// Orthonormal frame at a surface. The x axis of the frame is oblique to the edges of the surface (3-4-5 triangle), so
/// that the regular numbers of quasi-random sequences do not aim rays exactly at the edges of rooms.
struct ObliqueAxes
{
    Vec3 x, y, z;

    /// `normal`: the unit normal of the surface, on either side. It becomes z. Inline, since a new frame is made for
    /// every few rays.
    ObliqueAxes(const Surface& surface, Vec3 normal)
        : x(oblique(normalized(surface.edge_u), normal)), y(cross(normal, x)), z(normal)
    {
    }

    /// Transforms a vector from the frame, in which the normal is +z, to the coordinates of the scene.
    Vec3 turned(Vec3 local) const { return local.x * x + local.y * y + local.z * z; }

private:
    static Vec3 oblique(Vec3 along_edge, Vec3 normal) { return 0.6 * along_edge + 0.8 * cross(normal, along_edge); }
};

/// A spherical triangle: the projection of a flat triangle onto the unit sphere around a point.
class SphericalTriangle
{
public:
    /// `a`, `b`, `c`: unit vectors to the corners, in either orientation.
    SphericalTriangle(Vec3 a, Vec3 b, Vec3 c);

    /// Solid angle [sr]; 0 for a degenerate triangle.
    double solid_angle() const { return solid_angle_; }

    /// Uniform direction (unit vector) in the triangle for a point (u, v) of the unit square, density 1 / solid_angle
    /// (Arvo: Stratified sampling of spherical triangles, SIGGRAPH 1995). The solid angle must not be 0.
    Vec3 direction(double u, double v) const;

private:
    Vec3 a_;
    Vec3 b_;
    Vec3 c_;
    double cos_ab_;          ///< cosine of the arc from a to b
    double sin_alpha_ = 0.0; ///< sine of alpha, the angle at a
    double cos_alpha_ = 0.0;
    double solid_angle_ = 0.0; ///< [sr]
};

} // namespace multipath
