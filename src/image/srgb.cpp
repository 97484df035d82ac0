#include "image/srgb.h"

#include <cmath>

namespace multipath {

double srgb_encoded(double linear)
{
    if (!(linear > 0.0))
        return 0.0;
    if (linear >= 1.0)
        return 1.0;
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

Rgb srgb_encoded(Rgb linear)
{
    return {srgb_encoded(linear.r), srgb_encoded(linear.g), srgb_encoded(linear.b)};
}

double srgb_decoded(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

Rgb srgb_decoded(Rgb encoded)
{
    return {srgb_decoded(encoded.r), srgb_decoded(encoded.g), srgb_decoded(encoded.b)};
}

std::uint8_t screen_byte(double linear)
{
    return static_cast<std::uint8_t>(255.0 * srgb_encoded(linear) + 0.5);
}

} // namespace multipath
