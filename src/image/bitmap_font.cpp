#include "image/bitmap_font.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace multipath {

namespace {

constexpr int advance = 6; // five columns of a character and a gap

/// A line of characters side by side, drawn with X.
struct Sheet
{
    std::string_view characters;
    std::array<std::string_view, font_height> rows;
};

constexpr std::array<Sheet, 4> sheets = {{
    {"abcdefghijk",
     {"      X               X         XX        X       X      X  X    ",
      "      X               X        X  X       X                 X    ",
      " XXX  X XX   XXX   XX X  XXX   X     XXXX X XX   XX     XX  X  X ",
      "    X XX  X X   X X  XX X   X XXX   X   X XX  X   X      X  X X  ",
      " XXXX X   X X     X   X XXXXX  X    X   X X   X   X      X  XX   ",
      "X   X X   X X   X X   X X      X    X   X X   X   X      X  X X  ",
      " XXXX XXXX   XXX   XXXX  XXX   X     XXXX X   X  XXX     X  X  X ",
      "                                        X             X  X       ",
      "                                     XXX               XX        "}},
    {"lmnopqrstuv",
     {" XX                                              X               ",
      "  X                                              X               ",
      "  X   XX X  X XX   XXX  X XX   XX X X XX   XXXX XXX   X   X X   X",
      "  X   X X X XX  X X   X XX  X X  XX XX  X X      X    X   X X   X",
      "  X   X X X X   X X   X X   X X   X X      XXX   X    X   X X   X",
      "  X   X X X X   X X   X X   X X   X X         X  X  X X  XX  X X ",
      " XXX  X X X X   X  XXX  XXXX   XXXX X     XXXX    XX   XX X   X  ",
      "                        X         X                              ",
      "                        X         X                              "}},
    {"wxyzW\xB2/[]+-",
     {"                        X   X  XX       X  XXX   XXX             ",
      "                        X   X X  X      X  X       X    X        ",
      "X   X X   X X   X XXXXX X   X   X      X   X       X    X        ",
      "X   X  X X  X   X    X  X X X  X      X    X       X  XXXXX XXXXX",
      "X X X   X   X   X   X   X X X XXXX   X     X       X    X        ",
      "X X X  X X  X   X  X    XX XX       X      X       X    X        ",
      " X X  X   X  XXXX XXXXX X   X       X      XXX   XXX             ",
      "                X                                                ",
      "             XXX                                                 "}},
    {"0123456789.",
     {" XXX    X    XXX   XXX     X  XXXXX  XXX  XXXXX  XXX   XXX       ",
      "X   X  XX   X   X X   X   XX  X     X         X X   X X   X      ",
      "X  XX   X       X     X  X X  XXXX  X        X  X   X X   X      ",
      "X X X   X      X    XX  X  X      X XXXX     X   XXX   XXXX      ",
      "XX  X   X     X       X XXXXX     X X   X   X   X   X     X      ",
      "X   X   X    X    X   X    X  X   X X   X   X   X   X     X  XX  ",
      " XXX   XXX  XXXXX  XXX     X   XXX   XXX    X    XXX   XXX   XX  ",
      "                                                                 ",
      "                                                                 "}},
}};

/// Is the font pixel of a character set?
bool inked(char character, int column, int row)
{
    for (const Sheet& sheet : sheets) {
        const std::size_t place = sheet.characters.find(character);
        if (place != std::string_view::npos)
            return sheet.rows[static_cast<std::size_t>(row)][advance * place + static_cast<std::size_t>(column)] == 'X';
    }
    return false;
}

void fill_square(ScreenImage& picture, int x, int y, int side, std::uint8_t grey)
{
    const int right = std::min(x + side, picture.width);
    for (int row = std::max(y, 0); row < std::min(y + side, picture.height); ++row)
        for (int column = std::max(x, 0); column < right; ++column)
            std::fill_n(picture.at(column, row), 3, grey);
}

} // namespace

int text_width(std::string_view text)
{
    return text.empty() ? 0 : advance * static_cast<int>(text.size()) - 1;
}

void draw_text(ScreenImage& picture, int x, int y, int scale, std::string_view text, std::uint8_t grey)
{
    for (const char character : text) {
        for (int row = 0; row < font_height; ++row)
            for (int column = 0; column < advance - 1; ++column)
                if (inked(character, column, row))
                    fill_square(picture, x + scale * column, y + scale * row, scale, grey);
        x += scale * advance;
    }
}

} // namespace multipath
