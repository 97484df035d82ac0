#pragma once

#include "image/image.h"

#include <string>

namespace multipath {

/// A linear scale from 0 in a few round steps of mantissa * 10^exponent.
struct LegendScale
{
    int mantissa = 1;
    int exponent = 0;
    int steps = 1;

    double top() const;

    /// The number at the end of a step, such as "0.0025" or "25e-9"; exact.
    std::string number(int step) const;
};

/// The scale in 3 to 5 steps of 1, 2, 2.5 or 5 times a power of ten that reaches just far enough; from 0 to 1 for a
/// reach of 0.
LegendScale round_scale(double reach);

/// What the colours of a picture mean.
struct Legend
{
    std::string title; ///< quantity and unit, in the characters of draw_text
    LegendScale scale;
    bool exceeded = false; ///< there are values beyond the scale, shown like its end
};

/// [pixels] How much of a picture's height a legend with that title takes; 0 if the picture is too small for one.
int legend_height(int width, int height, const std::string& title);

/// The legend as a picture of its own, of a height found by legend_height.
ScreenImage legend_strip(int width, int height, const Legend& legend);

} // namespace multipath
