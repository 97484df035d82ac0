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

/// The colour in linear light. Some channels lie outside [0, 1] if a screen cannot show the colour.
Rgb linear_light(OkLab colour);

/// Colour (linear light) for a share of the scale, clamped to [0, 1]: from dark blue at 0 to light yellow at 1. Equal
/// steps of the share look about equally large. Lightness increases along the scale, so that the scale can be read
/// without seeing hues. Black is not in the map.
Rgb map_colour(double share);

} // namespace multipath
