#pragma once

#include "image/image.h"
#include "scene/rgb.h"

#include <array>
#include <string_view>

namespace multipath {

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

/// What a screen shows of radiosity [W/m^2] at a scale [m^2/W]: linear light, 1 is white.
Rgb screen_light(Rgb radiosity, ToneOperator tone, double scale);

/// The picture for the screen; rounded with a fixed pattern of thresholds, so that smooth walls show no bands.
ScreenImage tone_map(const Image& image, ToneOperator tone, double scale);

} // namespace multipath
