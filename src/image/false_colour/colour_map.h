#pragma once

#include "scene/rgb.h"

namespace multipath {

/// A colour in the perceptually uniform space OKLab (Ottosson 2020): lightness 0 ... 1 and two opponent axes, green to
/// red and blue to yellow. Equal distances look about equally large.
struct OkLab
{
    double lightness = 0.0;
    double green_red = 0.0;
    double blue_yellow = 0.0;
};

/// The colour in linear light. Channels lie outside [0, 1] if a screen cannot show it.
Rgb linear_light(OkLab colour);

/// Colour (linear light) for a share of the scale, clamped to [0, 1]: from dark blue at 0 to light yellow at 1. Equal
/// steps look about equally large, and lightness increases along the scale, so that it can be read without seeing hues.
/// The map does not contain black.
Rgb map_colour(double share);

} // namespace multipath
