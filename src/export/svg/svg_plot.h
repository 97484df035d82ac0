#pragma once

#include <cstddef>
#include <string>
#include <vector>

// Pieces of an SVG drawing as text; a drawing is their concatenation between head and end. Lengths are pixels at the
// drawing's own size, y down. The background is a white rectangle, so that a drawing looks the same in print and on a
// dark page. Colour-blind readers can tell the colours apart (Okabe and Ito).

namespace multipath {

/// A place in the drawing [px], y down.
struct SvgPoint
{
    double x;
    double y;
};

/// A path with these attributes, each ` name="value"`. Empty for an empty shape.
std::string svg_path(const std::string& shape, const std::string& attributes);

struct MarkStyle
{
    std::string colour;
    std::size_t shape; ///< one of twelve, all of about the same area, some 9 px across
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

/// Blue, vermilion, green, purple: the colours of a plot's series in order.
std::string svg_series_colour(std::size_t series);

/// From dark blue (0) to orange (1), steadily brighter.
std::string svg_ramp_colour(double share);

struct PlotTick
{
    double value;
    std::string label; ///< the part behind a '^' is a superscript: "10^6"
};

/// One direction of a plot: the values at its ends and what is written beside it. A logarithmic axis has logarithms as
/// values and its own labels.
struct PlotAxis
{
    std::string title;
    double low = 0.0;
    double high = 1.0;
    std::vector<PlotTick> ticks;
    std::vector<double> minor_ticks = {}; ///< shorter and without labels
};

/// An axis whose values are decimal logarithms, around data within [low, high] with a little room at both ends. Powers
/// of ten have ticks with labels; so have 2 and 5 times these if there is at most one power. The minor ticks stand at
/// the others of 2, 3, ... 9 times them or, where there are too many powers for all to have labels, at those without.
/// An empty interval, low > high, counts as [0, 1].
PlotAxis log_axis(const std::string& title, double low, double high);

/// A place in a plot, in the values of its axes.
struct PlotPoint
{
    double x;
    double y;
};

/// A rectangle of the drawing [px] with its axes.
struct Plot
{
    double left;
    double top;
    double width;
    double height;
    std::string title;
    PlotAxis across;
    PlotAxis up;
    double up_title_distance = 34.0; ///< [px] from the frame to the title of `up`

    SvgPoint at(PlotPoint point) const;
};

/// Everything that comes before the pieces. The title and the comments are for readers of the file, not drawn.
std::string svg_head(double width, double height, const std::string& title, const std::vector<std::string>& comments);
std::string svg_end();

enum class SvgAnchor { start, middle, end };

std::string svg_text(double x, double y, const std::string& text, SvgAnchor anchor, double size = 12.0);
std::string svg_text(double x, double y, const std::string& text, SvgAnchor anchor, double size,
                     const std::string& colour);

/// Light lines through the plot at the ticks that have labels.
std::string svg_grid(const Plot& plot);

/// Frame, ticks, labels and titles, around the plot: 36 px below, 20 above, to the left 12 more than the title's
/// distance.
std::string svg_axes(const Plot& plot);

/// One round dot per point, all in one path, which keeps the file small.
std::string svg_dots(const Plot& plot, const std::vector<PlotPoint>& points, const std::string& colour,
                     double diameter);

/// A line with a head, of constant size on paper, at its end; no head when the two are one place.
std::string svg_arrow(const Plot& plot, PlotPoint from, PlotPoint to, const std::string& colour);

/// The labels of series 0, 1, ... beside dots of their colours, in one row from `x` on.
std::string svg_legend(double x, double y, const std::vector<std::string>& labels);

} // namespace multipath
