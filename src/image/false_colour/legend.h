#pragma once

#include "image/image.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace multipath {

constexpr int font_height = 9; ///< [font pixels] from the top of an `h` to the bottom of a `g`
constexpr int font_ascent = 7; ///< [font pixels] from the top of an `h` to its foot

/// [font pixels] without the gap after the last character.
int text_width(std::string_view text);

/// Writes text into the picture with its upper left corner at (x, y), each font pixel a square of `scale` pixels; parts
/// outside the picture are cut off. Knows small letters, digits and the signs of numbers and units, `W` and Latin-1's
/// squared sign (\xB2) among them; other characters stay blank.
void draw_text(ScreenImage& picture, int x, int y, int scale, std::string_view text, std::uint8_t grey);

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

/// The meaning of the colours of a picture.
struct Legend
{
    std::string title; ///< quantity and unit, in the characters of draw_text
    LegendScale scale;
    bool exceeded = false; ///< there are values beyond the scale, shown like its end
    bool contours = false; ///< lines of the picture stand for the numbers

    /// The number of a step has a line: all but the ends do.
    bool has_contour(int step) const { return contours && step > 0 && (step < scale.steps || exceeded); }
    std::uint8_t contour_grey(int step) const; ///< seen well on the colours on both sides of the line
};

/// [pixels] Height of a legend with that title in a picture; 0 if the picture is too small for one.
int legend_height(int width, int height, const std::string& title);

/// The legend as a picture of its own, of a height found by legend_height.
ScreenImage legend_strip(int width, int height, const Legend& legend);

} // namespace multipath
