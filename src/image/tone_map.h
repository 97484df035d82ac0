#pragma once

#include "image/image.h"
#include "scene/rgb.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace multipath {

/// sRGB transfer function (IEC 61966-2-1): the encoded value in [0, 1] of linear light. Light is clamped to [0, 1]; NaN
/// counts as 0.
double srgb_encoded(double linear);
Rgb srgb_encoded(Rgb linear);

/// Linear light of sRGB values: the inverse of srgb_encoded(), for each channel in [0, 1].
Rgb srgb_decoded(Rgb encoded);

/// The sRGB value of a channel of linear light, rounded to an integer in 0 ... 255. Light is clamped as in
/// srgb_encoded().
std::uint8_t screen_byte(double linear);

enum class ToneOperator {
    linear,     ///< clipped at white
    reinhard,   ///< soft shoulder, natural colours (Reinhard et al. 2002)
    aces,       ///< S-shaped film curve (Narkowicz 2015)
    percentile, ///< linear, with white at the 98th percentile of the luminance, lamps left out
};

struct NamedToneOperator
{
    std::string_view name;
    ToneOperator tone;
};

/// All tone operators with the names that users give; options, the viewer's menu and tests iterate over this table.
inline constexpr std::array<NamedToneOperator, 4> tone_operators = {{{"reinhard", ToneOperator::reinhard},
                                                                     {"linear", ToneOperator::linear},
                                                                     {"aces", ToneOperator::aces},
                                                                     {"percentile", ToneOperator::percentile}}};

/// [m^2/W] Automatic exposure: the scale at which `tone` shows the mid-tones of the image as middle grey. For
/// ToneOperator::percentile it is the scale that shows the brightest part of the room, apart from its lamps, as white.
/// Black pixels are ignored, and lamps and dark corners have little influence. Returns 1 for a black image.
double automatic_scale(const std::vector<Rgb>& pixels, ToneOperator tone);

/// [m^2/W] The largest scale at which `tone` shows at most this share of the pixels that are not black as white.
/// Infinite for a black image.
double largest_scale(const std::vector<Rgb>& pixels, ToneOperator tone, double white_share);

/// [1] The input at which the output of the tone operator reaches white (1).
double white_point(ToneOperator tone);

/// [1] Linear light on the screen for a radiosity [W/m^2] at a scale [m^2/W], clamped to [0, 1]. 1 is white; NaN
/// becomes 0.
Rgb screen_light(Rgb radiosity, ToneOperator tone, double scale);

/// Converts an image [W/m^2] at a scale [m^2/W] to a picture for the screen, with ordered dithering so that smooth
/// walls show no bands.
ScreenImage tone_map(const Image& image, ToneOperator tone, double scale);

} // namespace multipath
