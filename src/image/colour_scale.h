#pragma once

#include "image/image.h"
#include "scene/rgb.h"

#include <cstdint>
#include <string>
#include <string_view>

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

constexpr int font_height = 9; ///< [font pixels] from the top of an `h` to the bottom of a `g`

/// [font pixels] Width of the text without the gap after its last character; 0 for an empty text.
int text_width(std::string_view text);

/// Draws text with its upper left corner at (x, y) [pixels] in a level of grey. Each font pixel becomes a square of
/// `scale` pixels; parts outside the picture are clipped. The font has lower-case letters, `W`, digits, `.`, `/`, `[`,
/// `]`, `+`, `-` and the superscript two of Latin-1 (\xB2). Other characters stay blank.
void draw_text(ScreenImage& picture, int x, int y, int scale, std::string_view text, std::uint8_t grey);

/// A linear scale that starts at 0 and has a few equal steps. The size of a step is the round number mantissa *
/// 10^exponent.
struct LegendScale
{
    int mantissa = 1;
    int exponent = 0;
    int steps = 1;

    double top() const; ///< the value at the end of the last step

    /// The value at the end of step 1, 2 ... as an exact decimal, such as "0.0025" or "25e-9"; "0" for step 0.
    std::string number(int step) const;
};

/// A scale from 0 to at least `reach` in 3 to 5 steps. The step is the smallest of 1, 2, 2.5 or 5 times a power of ten
/// with which 5 steps suffice. Returns the scale from 0 to 1 in one step unless `reach` is above 0.
LegendScale round_scale(double reach);

/// Explains the colours of a picture.
struct Legend
{
    std::string title; ///< quantity and unit; only characters that draw_text() knows are visible
    LegendScale scale;
    bool exceeded = false; ///< some values exceed the scale; they have the colour of its top
    bool contours = false; ///< the picture has contour lines at the numbers of the scale

    /// True if there is a contour line at the end of this step. There is none at 0, and at the top of the scale only if
    /// values exceed it.
    bool has_contour(int step) const { return contours && step > 0 && (step < scale.steps || exceeded); }
    /// Grey level of the contour line at the end of this step. It contrasts with the colours on both sides of the line.
    std::uint8_t contour_grey(int step) const;
};

/// [pixels] Height of the legend with this title in a picture of width x height pixels, which include the legend: at
/// most a third of `height`. 0 if the picture is too small for a legend.
int legend_height(int width, int height, const std::string& title);

/// Draws the legend as a separate picture. `height` must be a result of legend_height() other than 0.
ScreenImage legend_strip(int width, int height, const Legend& legend);

} // namespace multipath
