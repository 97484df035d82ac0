#pragma once

#include "scene/rgb.h"

namespace multipath {

/// A colour of the space OKLab: lightness 0 ... 1 and two hue axes, green to red and blue to yellow. Equal distances in
/// it look equally large.
struct OkLab
{
    double lightness = 0.0;
    double green_red = 0.0;
    double blue_yellow = 0.0;
};

/// The colour in linear light; outside [0, 1] where a screen cannot show it.
Rgb linear_light(OkLab colour);

/// The colour, in linear light, that stands for a share of a scale: from dark blue at 0 (or less) to light yellow at 1
/// (or more). Equal steps look equally large, and every step is lighter than the one before, so that the scale can be
/// read without seeing hues. Black is not in it.
Rgb map_colour(double share);

} // namespace multipath
