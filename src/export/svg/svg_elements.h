#pragma once

#include <cstddef>
#include <string>
#include <vector>

// Elements of an SVG drawing as text: numbers, attributes, and the marks and lines of a series in a plot, which differ
// in colour and in black and white.

namespace multipath {

/// A place in the drawing [px], y down.
struct SvgPoint
{
    double x;
    double y;
};

/// [px] with one decimal, without a trailing ".0": a drawing of thousands of points is mostly such numbers.
std::string svg_number(double value);

/// "12.5 7"
std::string svg_place(SvgPoint place);

/// Text as XML holds it. Control characters, which XML forbids, become '?'.
std::string svg_escaped(const std::string& text);

/// ` name="value"`, the value as it is.
std::string svg_attribute(const char* name, const std::string& value);

/// The attributes of a line that is not filled.
std::string svg_stroke(const std::string& colour, const std::string& width);

/// All of about the same area, some 9 px across.
enum class MarkShape {
    circle,
    square,
    triangle_up,
    diamond,
    triangle_down,
    cross,
    plus,
    star,
    triangle_left,
    hourglass,
    triangle_right,
    bow_tie
};

struct MarkStyle
{
    std::string colour;
    MarkShape shape;
};

/// [px] how far a mark reaches from its place, about.
constexpr double mark_radius = 4.5;

/// Twelve shapes and seven colours in turn, Okabe and Ito's without yellow, so that 84 series differ.
MarkStyle svg_series_mark(std::size_t series);

/// One mark per place, all in one path. Filled ones have a white rim, which parts those that overlap; hollow ones are
/// white inside. Empty if there are none.
std::string svg_marks(const std::vector<SvgPoint>& places, const MarkStyle& style, bool hollow);

struct LineStyle
{
    std::string colour;
    double width;            ///< [px]
    std::string dashes = {}; ///< [px] drawn, left out, ... as in stroke-dasharray; empty: solid
};

/// Straight pieces from place to place. Empty for less than two places.
std::string svg_polyline(const std::vector<SvgPoint>& places, const LineStyle& style);

/// A vertical bar [px], top <= bottom.
struct VerticalBar
{
    double x;
    double top;
    double bottom;
};

/// Empty if there are none.
std::string svg_bars(const std::vector<VerticalBar>& bars, const LineStyle& style);

} // namespace multipath
