#include "image/colour_scale.h"

#include "base/elementary.h"
#include "base/text_format.h"
#include "image/tone_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace multipath {

// The colour map is a polyline with segments of equal length in OKLab (B. Ottosson, A perceptual color space for image
// processing, 2020), in which equal distances look about equally large: a step of the value looks the same anywhere on
// the scale. From blue to yellow it passes through purple and orange but not green, so that no two of its colours
// differ only in red against green.

namespace {

constexpr std::array<OkLab, 7> milestones = {{{0.340, 0.030, -0.142},
                                              {0.452, 0.101, -0.129},
                                              {0.555, 0.153, -0.065},
                                              {0.654, 0.153, 0.021},
                                              {0.749, 0.110, 0.102},
                                              {0.850, 0.030, 0.130},
                                              {0.960, -0.037, 0.114}}};

double cube(double x)
{
    return x * x * x;
}

double between(double a, double b, double share)
{
    return a + share * (b - a);
}

} // namespace

Rgb linear_light(OkLab colour)
{
    const auto [lightness, a, b] = colour;
    const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

Rgb map_colour(double share)
{
    const double position = std::clamp(share, 0.0, 1.0) * static_cast<double>(milestones.size() - 1);
    const std::size_t segment = std::min(static_cast<std::size_t>(position), milestones.size() - 2);
    const double rest = position - static_cast<double>(segment);
    const OkLab from = milestones[segment];
    const OkLab to = milestones[segment + 1];
    return linear_light({between(from.lightness, to.lightness, rest), between(from.green_red, to.green_red, rest),
                         between(from.blue_yellow, to.blue_yellow, rest)});
}

// From top to bottom, a legend consists of the title, the colour bar, a tick mark for every step, and the numbers.
// Lengths are in font pixels, each of which is drawn as a square of as many pixels as the size of the picture allows.

namespace {

constexpr int advance = 6; // five columns per character and a gap

/// Bitmaps of characters side by side; X is a set font pixel.
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

/// True if the font pixel of a character is set.
bool inked(char character, int column, int row)
{
    for (const Sheet& sheet : sheets) {
        const std::size_t index = sheet.characters.find(character);
        if (index != std::string_view::npos)
            return sheet.rows[static_cast<std::size_t>(row)][advance * index + static_cast<std::size_t>(column)] == 'X';
    }
    return false;
}

/// Fills a rectangle; parts outside the picture are clipped.
void fill(ScreenImage& picture, int x, int y, int width, int height, std::uint8_t grey)
{
    for (int row = std::max(y, 0); row < std::min(y + height, picture.height); ++row)
        for (int column = std::max(x, 0); column < std::min(x + width, picture.width); ++column)
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
                    fill(picture, x + scale * column, y + scale * row, scale, scale, grey);
        x += scale * advance;
    }
}

namespace {

constexpr int font_ascent = 7; ///< from the top of an `h` to the baseline
constexpr int title_top = 4;
constexpr int bar_top = title_top + font_height + 2;
constexpr int bar_bottom = bar_top + 8;
constexpr int mark_bottom = bar_bottom + 2;
constexpr int numbers_top = mark_bottom + 2;
constexpr int strip_height = numbers_top + font_ascent + 4;
constexpr int side_margin = 24;         // half of the longest number, such as 0.00025+
constexpr int least_width = 300;        // fits the numbers of five steps side by side
constexpr std::uint8_t background = 32; // grey, distinct from black (no value) and from all map colours
constexpr std::uint8_t ink = 230;

} // namespace

std::uint8_t Legend::contour_grey(int step) const
{
    return 5 * step < 3 * scale.steps ? ink : 0; // the upper part of the scale is light
}

double LegendScale::top() const
{
    return steps * mantissa * elementary::pow(10.0, exponent);
}

std::string LegendScale::number(int step) const
{
    if (step == 0)
        return "0";
    if (exponent < -5 || exponent > 3)
        return std::to_string(step * mantissa) + "e" + std::to_string(exponent);
    return format("%.*f", std::max(0, -exponent), step * mantissa * elementary::pow(10.0, exponent));
}

LegendScale round_scale(double reach)
{
    if (!(reach > 0.0))
        return {};
    for (int exponent = static_cast<int>(std::floor(elementary::log10(reach))) - 2;; ++exponent)
        for (const int mantissa : {10, 20, 25, 50}) {
            // The tolerance prevents an extra step for a round `reach` with a rounding error.
            const double steps = std::ceil(reach / (mantissa * elementary::pow(10.0, exponent)) - 1e-9);
            if (steps > 5.0)
                continue;
            const bool ends_in_zero = mantissa % 10 == 0;
            return {ends_in_zero ? mantissa / 10 : mantissa, ends_in_zero ? exponent + 1 : exponent,
                    static_cast<int>(steps)};
        }
}

int legend_height(int width, int height, const std::string& title)
{
    const int needed_width = std::max(least_width, text_width(title) + 2 * side_margin);
    const int scale = std::min(width / needed_width, std::max(height / (6 * strip_height), 1));
    return 3 * strip_height <= height ? scale * strip_height : 0;
}

ScreenImage legend_strip(int width, int height, const Legend& legend)
{
    const int scale = height / strip_height;
    ScreenImage strip{width, height, {}};
    strip.bytes.assign(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), background);
    const int left = scale * side_margin;
    const int right = width - left;
    draw_text(strip, left, scale * title_top, scale, legend.title, ink);
    for (int x = left; x < right; ++x) {
        const Rgb colour = map_colour((x - left + 0.5) / (right - left));
        const std::array<std::uint8_t, 3> bytes = {screen_byte(colour.r), screen_byte(colour.g), screen_byte(colour.b)};
        for (int y = scale * bar_top; y < scale * bar_bottom; ++y)
            std::copy(bytes.begin(), bytes.end(), strip.at(x, y));
    }
    const int steps = legend.scale.steps;
    for (int step = 0; step <= steps; ++step) {
        const int middle = left + (right - left) * step / steps;
        const int mark = middle - scale / 2;
        fill(strip, mark, scale * bar_bottom, scale, scale * (mark_bottom - bar_bottom), ink);
        if (legend.has_contour(step) && step < steps)
            fill(strip, mark, scale * bar_top, scale, scale * (bar_bottom - bar_top), legend.contour_grey(step));
        const std::string number = legend.scale.number(step) + (legend.exceeded && step == steps ? "+" : "");
        draw_text(strip, middle - scale * text_width(number) / 2, scale * numbers_top, scale, number, ink);
    }
    return strip;
}

} // namespace multipath
