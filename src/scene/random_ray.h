#pragma once

#include "base/mix_bits.h"
#include "geometry/surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace multipath {

/// Random points and directions, the same on every machine, for rough estimates of how light spreads.
class RandomRay
{
public:
    /// Uniform in [0, 1).
    double number()
    {
        bits_ = mix_bits(bits_);
        return static_cast<double>(bits_ >> 11) * 0x1p-53;
    }

    /// A point of a surface, uniform on a parallelogram and nearly so on a triangle.
    Vec3 point(const Surface& surface)
    {
        const double u = number();
        return surface.at(u, number() * (surface.shape == Shape::triangle ? 1.0 - u : 1.0));
    }

    /// The normal plus a point of the unit sphere: a cosine-weighted direction if that point is uniform. It is not
    /// quite, since x is uniform instead of the azimuth: cheaper, and good enough for estimates.
    Vec3 direction(Vec3 normal)
    {
        const double z = 2.0 * number() - 1.0;
        const double x = 2.0 * number() - 1.0;
        const double y = (number() < 0.5 ? -1.0 : 1.0) * std::sqrt(std::max(0.0, 1.0 - x * x));
        const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
        return normal + Vec3{r * x, r * y, z};
    }

private:
    std::uint64_t bits_ = 1;
};

} // namespace multipath
