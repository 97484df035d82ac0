#pragma once

#include "image/image.h"

#include <cstdint>
#include <string_view>

namespace multipath {

constexpr int font_height = 9; ///< [font pixels] from the top of an `h` to the bottom of a `g`
constexpr int font_ascent = 7; ///< [font pixels] from the top of an `h` to its foot

/// [font pixels] without the gap after the last character.
int text_width(std::string_view text);

/// Writes text into the picture with its upper left corner at (x, y), each font pixel a square of `scale` pixels; what
/// lies outside is cut off. Knows small letters, digits and the signs of numbers and units, `W` and Latin-1's squared
/// sign (\xB2) among them; the rest stays blank.
void draw_text(ScreenImage& picture, int x, int y, int scale, std::string_view text, std::uint8_t grey);

} // namespace multipath
