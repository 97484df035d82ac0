#pragma once

#include "image/image.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace multipath {

constexpr int font_height = 9; ///< [font pixels] from the top of an `h` to the bottom of a `g`
constexpr int font_ascent = 7; ///< [font pixels] from the top of an `h` to the baseline

/// [font pixels] Width of the text without the gap after its last character.
int text_width(std::string_view text);

/// Draws text with its upper left corner at (x, y), each font pixel as a square of `scale` pixels, clipped to the
/// picture. The font has lower-case letters, `W`, digits, `.`, `/`, `[`, `]`, `+`, `-` and the superscript two of
/// Latin-1 (\xB2); other characters stay blank.
void draw_text(ScreenImage& picture, int x, int y, int scale, std::string_view text, std::uint8_t grey);

/// A linear scale that starts at 0 and has a few round steps of size mantissa * 10^exponent.
struct LegendScale
{
    int mantissa = 1;
    int exponent = 0;
    int steps = 1;

    double top() const; ///< the value at the end of the last step

    /// The value at the end of a step as an exact decimal, such as "0.0025" or "25e-9".
    std::string number(int step) const;
};

/// A scale from 0 to at least `reach` in 3 to 5 steps. The step is the smallest of 1, 2, 2.5 or 5 times a power of ten
/// of which 5 suffice. Returns a scale from 0 to 1 if `reach` is 0.
LegendScale round_scale(double reach);

/// Explains the colours of a picture.
struct Legend
{
    std::string title; ///< quantity and unit, in the characters of draw_text
    LegendScale scale;
    bool exceeded = false; ///< values above the scale exist, shown in the colour of its top
    bool contours = false; ///< the picture has contour lines at the numbers of the scale

    /// True if there is a contour line at the end of this step: not at 0, and at the top only if values exceed it.
    bool has_contour(int step) const { return contours && step > 0 && (step < scale.steps || exceeded); }
    std::uint8_t contour_grey(int step) const; ///< grey level of the line, in contrast to the colours on both sides
};

/// [pixels] Height of a legend with this title for a picture of this size; 0 if the picture is too small for one.
int legend_height(int width, int height, const std::string& title);

/// Draws the legend as a separate picture; `height` must come from legend_height().
ScreenImage legend_strip(int width, int height, const Legend& legend);

} // namespace multipath
