#include "sampling/warp.h"

#include <algorithm>

namespace multipath {

SurfacePoint square_to_uniform_triangle(double a, double b)
{
    const double width =
        std::sqrt(1.0 - a); // of the triangle in v at u = 1 - width; the share width^2 lies beyond this u
    return {1.0 - width, b * width};
}

namespace {

/// The unit vector on the arc from `axis` towards `other` whose cosine with `axis` is given.
Vec3 along_arc(Vec3 axis, Vec3 other, double cosine)
{
    const double bounded = std::clamp(cosine, -1.0, 1.0);
    return bounded * axis + std::sqrt(1.0 - bounded * bounded) * normalized(other - dot(other, axis) * axis);
}

} // namespace

SphericalTriangle::SphericalTriangle(Vec3 a, Vec3 b, Vec3 c) : a_(a), b_(b), c_(c), cos_ab_(dot(a, b))
{
    // Solid angle by van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30 (1983), accurate for small triangles too.
    const double volume = std::abs(dot(a, cross(b, c)));
    const double denominator = 1.0 + dot(a, b) + dot(b, c) + dot(c, a);
    const Vec3 normal_ab = cross(a, b);
    const Vec3 normal_ac = cross(a, c);
    const double lengths = length(normal_ab) * length(normal_ac);
    if (!(volume > 0.0) || !(lengths > 0.0))
        return;
    solid_angle_ = 2.0 * elementary::atan2(volume, denominator);
    cos_alpha_ = dot(normal_ab, normal_ac) / lengths;
    sin_alpha_ = volume / lengths; // |(a x b) x (a x c)| = |a (a . (b x c))|
}

Vec3 SphericalTriangle::direction(double u, double v) const
{
    // The arc from b to a point c' between a and c cuts off the share u of the triangle; `cosine` is that of the arc a
    // c'.
    const double part = u * solid_angle_;
    const double s = elementary::sin(part) * cos_alpha_ - elementary::cos(part) * sin_alpha_; // sin(part - alpha)
    const double t = elementary::cos(part) * cos_alpha_ + elementary::sin(part) * sin_alpha_; // cos(part - alpha)
    const double p = t - cos_alpha_;
    const double q = s + sin_alpha_ * cos_ab_;
    const double divisor = (q * s + p * t) * sin_alpha_;
    const double cosine = divisor != 0.0 ? ((q * t - p * s) * cos_alpha_ - q) / divisor : 1.0;
    const Vec3 c = along_arc(a_, c_, cosine);
    return along_arc(b_, c, 1.0 - v * (1.0 - dot(c, b_)));
}

} // namespace multipath
