#pragma once

#include "scene/rgb.h"

#include <cstdint>

namespace multipath {

/// The transfer function of IEC 61966-2-1, from linear light in [0, 1] to the encoded value in [0, 1]; what is outside
/// counts as the end that it is beyond, and what is no number as 0.
double srgb_encoded(double linear);
Rgb srgb_encoded(Rgb linear);

/// Its inverse.
double srgb_decoded(double encoded);
Rgb srgb_decoded(Rgb encoded);

/// What a screen needs to show a channel of linear light, nearest of 256 steps.
std::uint8_t screen_byte(double linear);

} // namespace multipath
