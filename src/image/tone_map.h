#pragma once

#include "image/image.h"
#include "scene/rgb.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace multipath {

/// The transfer function of sRGB (IEC 61966-2-1), from linear light to the encoded value in [0, 1]. Light is clamped to
/// [0, 1]; NaN counts as 0.
double srgb_encoded(double linear);
Rgb srgb_encoded(Rgb linear);

/// Its inverse.
Rgb srgb_decoded(Rgb encoded);

/// A channel of linear light as the nearest sRGB byte.
std::uint8_t screen_byte(double linear);

enum class ToneOperator {
    linear,     ///< clipped at white
    reinhard,   ///< soft shoulder, natural colours
    aces,       ///< S-shaped film curve
    percentile, ///< linear, with white at the brightest part of the room
};

struct NamedToneOperator
{
    std::string_view name;
    ToneOperator tone;
};

/// All of them as users call them; options, the viewer's menu and tests go through this table.
inline constexpr std::array<NamedToneOperator, 4> tone_operators = {{{"reinhard", ToneOperator::reinhard},
                                                                     {"linear", ToneOperator::linear},
                                                                     {"aces", ToneOperator::aces},
                                                                     {"percentile", ToneOperator::percentile}}};

/// [m^2/W] The scale that puts the room's mid-tones where a photographer would, for an image seen through `tone`.
/// Ignores black pixels and does not let lamps or dark corners decide. 1 for a black image.
double automatic_scale(const Image& image, ToneOperator tone);

/// The input at which an operator's output reaches white.
double white_point(ToneOperator tone);

/// Linear light on the screen for radiosity [W/m^2] at a scale [m^2/W]; 1 is white.
Rgb screen_light(Rgb radiosity, ToneOperator tone, double scale);

/// The picture for the screen; rounded with a fixed pattern of thresholds, so that smooth walls show no bands.
ScreenImage tone_map(const Image& image, ToneOperator tone, double scale);

} // namespace multipath
