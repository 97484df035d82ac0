#pragma once

#include "export/svg_element.h"

#include <cstddef>
#include <string>
#include <vector>

// What tells the series of a plot apart, in colour and in black and white.

namespace multipath {

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
