// The basic functions (exponential, logarithm, sine and cosine, arctangent) reduce their argument to a small interval,
// evaluate a truncated Taylor series there and put the result together again; the other functions are built from them.
// Only operations that IEEE 754 rounds correctly are used, besides those that are exact (ldexp, frexp, floor), so that
// the results are the same on every machine.

#include "base/elementary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace multipath {
namespace elementary {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// ln 2 as a sum of two parts: the product of an exponent and the first part is exact.
constexpr double ln2_high = 0x1.62e42feep-1;
constexpr double ln2_low = 0x1.a39ef35793c76p-33;
constexpr double ln2 = 0x1.62e42fefa39efp-1;
constexpr double ln10 = 0x1.26bb1bbb55516p+1;

/// c[0] + c[1] x + ... by two Horner schemes, for the even and the odd terms, which run in parallel.
template <std::size_t count>
double polynomial(const double (&c)[count], double x)
{
    static_assert(count % 2 == 0, "as many even as odd terms");
    const double square = x * x;
    double even = c[count - 2];
    double odd = c[count - 1];
    for (std::size_t k = count - 2; k > 0; k -= 2) {
        even = c[k - 2] + square * even;
        odd = c[k - 1] + square * odd;
    }
    return even + x * odd;
}

/// e^r 2^k for |r| <= 0.35 by the Taylor series, whose remainder is below r^14 / 14! = 5e-18.
double scaled_exp(double r, int k)
{
    constexpr double terms[] = {1.0 / 2,       1.0 / 6,        1.0 / 24,        1.0 / 120,
                                1.0 / 720,     1.0 / 5040,     1.0 / 40320,     1.0 / 362880,
                                1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
    return std::ldexp(1.0 + (r + r * r * polynomial(terms, r)), k);
}

/// x^n for n >= 0 by repeated squaring.
double whole_power(double x, int n)
{
    double result = 1.0;
    for (double square = x; n > 0; n /= 2, square *= square)
        result *= n % 2 != 0 ? square : 1.0;
    return result;
}

/// Arctangent for |t| <= 1/16 by the Taylor series, whose relative remainder is below t^14 / 15 = 1e-18.
double series_of_atan(double t)
{
    constexpr double terms[] = {-1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11, 1.0 / 13};
    const double z = t * t;
    return t + t * z * polynomial(terms, z);
}

/// Arctangent for 0 <= x <= 1: atan x = atan a + atan((x - a) / (1 + x a)) with a the nearest multiple of 1/8.
double atan_up_to_one(double x)
{
    constexpr double atan_of_eighths[] = {0.0,
                                          0x1.fd5ba9aac2f6ep-4,
                                          0x1.f5b75f92c80ddp-3,
                                          0x1.6f61941e4def1p-2,
                                          0x1.dac670561bb4fp-2,
                                          0x1.1e00babdefeb4p-1,
                                          0x1.4978fa3269ee1p-1,
                                          0x1.700a7c5784634p-1,
                                          0x1.921fb54442d18p-1};
    const int k = static_cast<int>(8.0 * x + 0.5);
    const double near = k / 8.0;
    return atan_of_eighths[k] + series_of_atan((x - near) / (1.0 + x * near));
}

/// x = 2^exponent * mantissa with sqrt(1/2) <= mantissa < sqrt(2).
struct Parts
{
    double mantissa;
    int exponent;
};

Parts parts_of(double x)
{
    constexpr double sqrt_half = 0.7071067811865476;
    Parts parts{};
    parts.mantissa = std::frexp(x, &parts.exponent);
    if (parts.mantissa < sqrt_half) {
        parts.mantissa *= 2.0;
        --parts.exponent;
    }
    return parts;
}

bool is_whole(double x)
{
    return x == std::floor(x);
}

SinCos sin_cos(double x)
{
    const double turns = std::abs(x) / (2.0 * pi);
    const SinCos angle = sin_cos_of_turns(turns - std::floor(turns));
    return {x < 0.0 ? -angle.sin : angle.sin, angle.cos};
}

} // namespace

double exp(double x)
{
    constexpr double largest = 709.8;
    constexpr double smallest = -745.2;
    if (!(x >= smallest))
        return x < smallest ? 0.0 : x;
    if (x > largest)
        return infinity;
    const double k = std::floor(x / ln2 + 0.5);
    return scaled_exp((x - k * ln2_high) - k * ln2_low, static_cast<int>(k));
}

/// ln x = exponent ln 2 + ln m, with ln m = 2 artanh((m - 1) / (m + 1)) by its Taylor series.
double log(double x)
{
    if (!(x > 0.0 && x < infinity))
        return x == 0.0 ? -infinity : x < 0.0 ? nan : x;
    const Parts parts = parts_of(x);
    const double e = parts.exponent;
    const double f = parts.mantissa - 1.0;
    const double s = f / (2.0 + f);
    const double z = s * s; // <= 0.0295, so that the relative remainder is below z^11 / 23 = 6e-19
    constexpr double terms[] = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11,
                                2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21};
    // 2 s = f - s f, so that the first summand f is exact.
    return e * ln2_high + (f - (s * (f - z * polynomial(terms, z)) - e * ln2_low));
}

double log10(double x)
{
    const double result = log(x) / ln10;
    const double whole = std::floor(result + 0.5);
    return std::abs(whole) < 300.0 && pow(10.0, whole) == x ? whole : result;
}

double pow(double x, double y)
{
    constexpr double most = 1024.0;
    if (y == 0.0 || x == 1.0)
        return 1.0;
    if (is_whole(y) && std::abs(y) <= most) {
        const double power = whole_power(x, static_cast<int>(std::abs(y)));
        return y > 0.0 ? power : 1.0 / power;
    }
    if (x < 0.0)
        return nan;
    return exp(y * log(x));
}

double sin(double x)
{
    return sin_cos(x).sin;
}

double cos(double x)
{
    return sin_cos(x).cos;
}

double tan(double x)
{
    const SinCos angle = sin_cos(x);
    return angle.sin / angle.cos;
}

double atan(double x)
{
    return atan2(x, 1.0);
}

double atan2(double y, double x)
{
    const double a = std::abs(x);
    const double b = std::abs(y);
    if (!(a >= 0.0 && b >= 0.0))
        return nan;
    double angle = 0.0;
    if (a == b)
        angle = a == 0.0 ? 0.0 : 0.25 * pi;
    else
        angle = b < a ? atan_up_to_one(b / a) : 0.5 * pi - atan_up_to_one(a / b);
    return std::copysign(std::signbit(x) ? pi - angle : angle, y);
}

double asinh(double x)
{
    const double a = std::abs(x);
    if (!(a < 1e150)) // the square would overflow
        return x + x == x ? x : std::copysign(log(a) + ln2, x);
    // ln(1 + u) = ln(w) u / (w - 1) with w the rounded 1 + u: the rounding error of w cancels (Kahan).
    const double u = a + a * a / (1.0 + std::sqrt(1.0 + a * a));
    const double w = 1.0 + u;
    return std::copysign(w == 1.0 ? u : log(w) * (u / (w - 1.0)), x);
}

double hypot(double x, double y)
{
    const double larger = std::max(std::abs(x), std::abs(y));
    if (!(larger > 1e-150 && larger < 1e150)) { // squares would overflow or underflow
        const double smaller = std::min(std::abs(x), std::abs(y));
        const double ratio = smaller / larger;
        return larger == 0.0 || larger == infinity ? larger : larger * std::sqrt(1.0 + ratio * ratio);
    }
    return std::sqrt(x * x + y * y);
}

} // namespace elementary
} // namespace multipath
