#include "viewer/shared_exponent.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

constexpr int mantissa_bits = 9;
constexpr int exponent_bias = 15;
constexpr int most_mantissa = 511;

double clipped(double channel)
{
    return channel > 0.0 ? std::min(channel, largest_shared) : 0.0; // not a number fails every comparison
}

} // namespace

std::uint32_t shared_exponent(Rgb colour)
{
    const Rgb c = {clipped(colour.r), clipped(colour.g), clipped(colour.b)};
    const double brightest = std::max({c.r, c.g, c.b});
    int exponent = 0;
    if (brightest > 0.0) {
        int magnitude = 0;
        std::frexp(brightest, &magnitude); // brightest < 2^magnitude
        exponent = std::max(0, magnitude + exponent_bias);
    }
    // Rounding may carry into a tenth bit.
    if (std::lround(std::ldexp(brightest, mantissa_bits + exponent_bias - exponent)) > most_mantissa)
        ++exponent;
    const auto mantissa = [&](double channel) {
        return static_cast<std::uint32_t>(std::lround(std::ldexp(channel, mantissa_bits + exponent_bias - exponent)));
    };
    return mantissa(c.r) | mantissa(c.g) << 9 | mantissa(c.b) << 18 | static_cast<std::uint32_t>(exponent) << 27;
}

} // namespace multipath
