#pragma once

#include "base/elementary.h"

#include <cmath>

namespace multipath {

/// Three independent colour channels of one quantity; its unit is given where a variable is declared.
struct Rgb
{
    double r = 0.0;
    double g = 0.0;
    double b = 0.0;

    Rgb& operator+=(Rgb other)
    {
        r += other.r;
        g += other.g;
        b += other.b;
        return *this;
    }
};

inline Rgb operator+(Rgb a, Rgb b)
{
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}
inline Rgb operator-(Rgb a, Rgb b)
{
    return {a.r - b.r, a.g - b.g, a.b - b.b};
}
inline Rgb operator*(Rgb a, Rgb b)
{
    return {a.r * b.r, a.g * b.g, a.b * b.b};
}
inline Rgb operator*(double s, Rgb a)
{
    return {s * a.r, s * a.g, s * a.b};
}
inline bool operator==(Rgb a, Rgb b)
{
    return a.r == b.r && a.g == b.g && a.b == b.b;
}
inline bool operator!=(Rgb a, Rgb b)
{
    return !(a == b);
}

/// f of each channel: of one colour, or of the same channel of several.
template <class Function, class... Colours>
Rgb by_channel(const Function& f, Colours... colours)
{
    return {f(colours.r...), f(colours.g...), f(colours.b...)};
}

/// a / b, or 0 where b is 0; for colours, channel by channel.
inline double quotient(double a, double b)
{
    return b != 0.0 ? a / b : 0.0;
}
inline Rgb quotient(Rgb a, Rgb b)
{
    return by_channel([](double x, double y) { return quotient(x, y); }, a, b);
}

inline double square_root(double a)
{
    return std::sqrt(a);
}
inline Rgb square_root(Rgb a)
{
    return by_channel([](double x) { return std::sqrt(x); }, a);
}

/// True if a <= b; for colours, in all channels.
inline bool at_most(double a, double b)
{
    return a <= b;
}
inline bool at_most(Rgb a, Rgb b)
{
    return a.r <= b.r && a.g <= b.g && a.b <= b.b;
}

/// The mean of the channels, used where the multi-path method needs one number instead of three channels
/// (docs/method.md, Symbols). For r = g = b it is exactly r; (r + g + b) / 3 may differ from that in the last bit.
inline double mean(Rgb a)
{
    return a.r == a.g && a.g == a.b ? a.r : (a.r + a.g + a.b) / 3.0;
}

/// Linear light of an sRGB value, both in [0, 1] (IEC 61966-2-1).
inline double srgb_decoded(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : elementary::pow((encoded + 0.055) / 1.055, 2.4);
}

} // namespace multipath
