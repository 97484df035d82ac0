#pragma once

namespace multipath {

constexpr double pi = 3.14159265358979323846;

/// Sine and cosine of one angle.
struct SinCos
{
    double sin;
    double cos;
};

/// Sine and cosine of the angle 2 pi * turns for 0 <= turns <= 1, with an absolute error below 2e-16.
inline SinCos sin_cos_of_turns(double turns)
{
    // Range reduction: turns = quarter / 4 + rest with |rest| <= 1/8. The subtraction is exact,
    // except that it is off by 2^-56 for the largest number below 1/8.
    const int quarter = static_cast<int>(4.0 * turns + 0.5);
    const double rest = turns - 0.25 * quarter;
    const double x = 2.0 * pi * rest;
    const double y = x * x;
    // Taylor series on |x| <= pi/4; the first omitted terms are x^17/17! and x^18/18!.
    const double s =
        x * (1.0 +
             y * (-1.0 / 6 +
                  y * (1.0 / 120 + y * (-1.0 / 5040 + y * (1.0 / 362880 + y * (-1.0 / 39916800 +
                                                                               y * (1.0 / 6227020800.0 +
                                                                                    y * (-1.0 / 1307674368000.0))))))));
    const double c =
        1.0 + y * (-1.0 / 2 +
                   y * (1.0 / 24 +
                        y * (-1.0 / 720 +
                             y * (1.0 / 40320 +
                                  y * (-1.0 / 3628800 + y * (1.0 / 479001600 + y * (-1.0 / 87178291200.0 +
                                                                                    y * (1.0 / 20922789888000.0))))))));
    const bool swap = (quarter & 1) != 0;
    const double sine = swap ? c : s;
    const double cosine = swap ? s : c;
    return {(quarter & 2) != 0 ? -sine : sine, ((quarter + 1) & 2) != 0 ? -cosine : cosine};
}

/// Elementary functions made of operations that IEEE 754 rounds correctly, so that results do not depend on the
/// machine: C libraries differ in the last bits, even from one processor to the next. Relative errors are below 4.4e-16
/// unless noted. Infinities and NaN give the same results as in the C library, except in pow() and in hypot() of a NaN.
/// Angles are in radians; the arguments of sin(), cos() and tan() must be finite and should not be large.
namespace elementary {

double exp(double x);
double log(double x);
double log10(double x); ///< relative error below 6.6e-16; exact for powers of 10 from 1e-22 to 1e22
/// x^y. Integer powers with |y| <= 1024 are computed by repeated squaring and are exact if all products are; for
/// y < 0 the reciprocal of x^|y| is rounded. Other powers are NaN if x < 0, and have a relative error below 4.4e-16 +
/// 1e-15 |y ln x| if x >= 0.
double pow(double x, double y);
double sin(double x); ///< absolute error below 4e-16 for |x| <= 2 pi; relative error below 4.4e-16 for |x| <= 1
double cos(double x); ///< errors as for sin()
double tan(double x); ///< relative error below 1.8e-15 for |x| <= 1.4
double atan(double x);
double atan2(double y, double x);
double asinh(double x); ///< relative error below 9e-16
double hypot(double x, double y);

} // namespace elementary

} // namespace multipath
