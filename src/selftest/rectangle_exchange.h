#pragma once

#include "geometry/elementary.h"
#include "geometry/pi.h"

#include <cmath>

namespace multipath {

// Closed forms of the exchange area A F [m^2] of two rectangles, the area of one times its form factor to the other:
// A F = A_1 F_12 = A_2 F_21. From Howell, A Catalog of Radiation Heat Transfer Configuration Factors.

/// The coordinates [m] at which a rectangle begins and ends along one axis.
struct Interval
{
    double low;
    double high;
    /// `low` for k = 0, `high` for k = 1.
    double operator[](int k) const { return k == 0 ? low : high; }
};

/// The sign of a term of the closed forms, which sum over both ends of four intervals: (-1)^(i + j + k + l).
inline double sign_of(int i, int j, int k, int l)
{
    return (i + j + k + l) % 2 == 0 ? 1.0 : -1.0;
}

/// [m^2] A F of the rectangles x1 * y1 and x2 * y2 in parallel planes at the distance z > 0 [m] (Howell C-13).
inline double parallel_rectangles(Interval x1, Interval y1, Interval x2, Interval y2, double z)
{
    const auto term = [&](double u, double v) {
        const double p = std::sqrt(u * u + z * z);
        const double q = std::sqrt(v * v + z * z);
        return v * p * elementary::atan(v / p) + u * q * elementary::atan(u / q) -
               0.5 * z * z * elementary::log(u * u + v * v + z * z);
    };
    double sum = 0.0;
    for (int bits = 0; bits < 16; ++bits) {
        const int i = bits & 1, j = bits >> 1 & 1, k = bits >> 2 & 1, l = bits >> 3;
        sum += sign_of(i, j, k, l) * term(x1[i] - x2[k], y1[j] - y2[l]);
    }
    return sum / (2.0 * pi);
}

/// [m^2] A F of the rectangles x1 * y in the plane z = 0 and x2 * z in the plane y = 0 (Howell C-15). Each rectangle
/// lies on the positive side of the other's plane: y.low, z.low >= 0.
inline double perpendicular_rectangles(Interval x1, Interval y, Interval x2, Interval z)
{
    const auto term = [](double u, double c2) {
        const double c = std::sqrt(c2);
        const double square = u * u + c2;
        return (c > 0.0 ? u * c * elementary::atan(u / c) : 0.0) -
               (square > 0.0 ? 0.25 * (c2 - u * u) * elementary::log(square) : 0.0);
    };
    double sum = 0.0;
    for (int bits = 0; bits < 16; ++bits) {
        const int i = bits & 1, j = bits >> 1 & 1, k = bits >> 2 & 1, l = bits >> 3;
        sum += sign_of(i, j, k, l) * term(x1[i] - x2[k], y[j] * y[j] + z[l] * z[l]);
    }
    return sum / (2.0 * pi);
}

} // namespace multipath
