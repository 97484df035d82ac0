#pragma once

#include "geometry/elementary.h"
#include "geometry/surface.h"
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

/// Point of a surface, density 1 / area.
inline Vec3 square_to_uniform_surface(const Surface& surface, double a, double b)
{
    if (surface.shape == Shape::parallelogram)
        return surface.at(a, b);
    const Barycentric place = square_to_uniform_triangle(a, b);
    return surface.at(place.u, place.v);
}

/// Orthonormal axes at a surface, oblique to its edges (3-4-5 triangle), so that regular numbers do not aim exactly at
/// the edges of rooms.
struct ObliqueAxes
{
    Vec3 x, y, z;

    /// `normal`: of the surface, on either side. Inline: made for every few rays.
    ObliqueAxes(const Surface& surface, Vec3 normal)
        : x(oblique(normalized(surface.edge_u), normal)), y(cross(normal, x)), z(normal)
    {
    }

    /// A vector of the maps about +z, about the normal.
    Vec3 turned(Vec3 local) const { return local.x * x + local.y * y + local.z * z; }

private:
    static Vec3 oblique(Vec3 along_edge, Vec3 normal) { return 0.6 * along_edge + 0.8 * cross(normal, along_edge); }
};

/// A triangle on the unit sphere: what a flat triangle hides of the sky at a point.
class SphericalTriangle
{
public:
    /// Unit vectors to the corners, in any sense of rotation.
    SphericalTriangle(Vec3 a, Vec3 b, Vec3 c);

    /// [sr] 0 for a degenerate one.
    double solid_angle() const { return solid_angle_; }

    /// Direction with density 1 / solid_angle (Arvo: Stratified sampling of spherical triangles, SIGGRAPH 1995). The
    /// solid angle must not be 0.
    Vec3 direction(double u, double v) const;

private:
    Vec3 a_;
    Vec3 b_;
    Vec3 c_;
    double cos_ab_;
    double sin_alpha_ = 0.0; ///< angle at a
    double cos_alpha_ = 0.0;
    double solid_angle_ = 0.0;
};

} // namespace multipath
