#pragma once

#include "geometry/vec3.h"

namespace multipath {

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
