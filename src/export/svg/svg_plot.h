#pragma once

#include <cstddef>
#include <string>
#include <vector>

// SVG elements as text. A drawing is the concatenation of svg_head(), elements, and svg_end(). Lengths are in pixels
// [px] at the original size of the drawing, y down. The background is a white rectangle, so that a drawing looks the
// same in print and on a dark page. Series have the colours of Okabe and Ito, which colour-blind readers can
// distinguish. Texts are escaped for XML; colours and attributes are not.

namespace multipath {

/// A point of the drawing [px], y down.
struct SvgPoint
{
    double x;
    double y;
};

/// A path element. `shape`: path data. `attributes`: each in the form ` name="value"`. Empty for an empty shape.
std::string svg_path(const std::string& shape, const std::string& attributes);

/// The attributes of a stroked path without fill. `width`: [px].
std::string svg_stroke(const std::string& colour, const std::string& width);

struct MarkStyle
{
    std::string colour;
    std::size_t shape; ///< 0 ... 11; all shapes have about the same area and are about 9 px wide
};

/// Mark of a series. The marks of the first 96 series differ: they are all pairs of twelve shapes and eight colours
/// (those of Okabe and Ito, but dark grey instead of black and brown instead of yellow).
MarkStyle svg_series_mark(std::size_t series);

/// One mark per point, all in one path. Filled marks have a white rim, which separates overlapping marks. `hollow`:
/// marks are white inside. Empty for no points.
std::string svg_marks(const std::vector<SvgPoint>& points, const MarkStyle& style, bool hollow);

struct LineStyle
{
    std::string colour;
    double width;            ///< [px]
    std::string dashes = {}; ///< [px] lengths of dashes and gaps, as in stroke-dasharray; empty for a solid line
};

/// Straight segments from point to point. Empty for fewer than two points.
std::string svg_polyline(const std::vector<SvgPoint>& points, const LineStyle& style);

/// A vertical bar [px], top <= bottom.
struct VerticalBar
{
    double x;
    double top;
    double bottom;
};

/// All bars in one path. Empty for no bars.
std::string svg_bars(const std::vector<VerticalBar>& bars, const LineStyle& style);

/// Colour of a series: cycles through blue, vermilion, green and purple.
std::string svg_series_colour(std::size_t series);

/// Colour ramp from dark blue for share 0 to orange for share 1, with increasing brightness.
std::string svg_ramp_colour(double share);

struct PlotTick
{
    double value;
    std::string label; ///< the part after a '^' is a superscript: "10^6"
};

/// An axis of a plot: the values at both ends of the axis, and its labels. On a logarithmic axis all values are decimal
/// logarithms.
struct PlotAxis
{
    std::string title;
    double low = 0.0;
    double high = 1.0;
    std::vector<PlotTick> ticks;
    std::vector<double> minor_ticks = {}; ///< shorter and without labels
};

/// A logarithmic axis for data whose decimal logarithms lie in [low, high], with a margin at both ends. Powers of ten
/// have labelled ticks. If the axis contains at most one power, 2 and 5 times a power also have labels. Minor ticks
/// are at the other multiples 2 ... 9 of the powers. If there are too many powers to label all of them, minor ticks are
/// at the unlabelled powers instead. An empty interval, low > high, counts as [0, 1].
PlotAxis log_axis(const std::string& title, double low, double high);

/// A point of a plot, in the values of the two axes.
struct PlotPoint
{
    double x;
    double y;
};

/// A plot: a rectangle of the drawing [px] with two axes. `left` and `top` are the position of its upper left corner.
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

    SvgPoint at(PlotPoint point) const; ///< position of a point in the drawing
};

/// The text of a drawing of width x height [px] before its elements. The title and the comments become metadata and are
/// not drawn.
std::string svg_head(double width, double height, const std::string& title, const std::vector<std::string>& comments);
/// The text of a drawing after its elements.
std::string svg_end();

constexpr const char* svg_dark_grey = "#222222";

enum class SvgAnchor { start, middle, end };

/// A text with this font size [px]. (x, y) is the start, middle or end of its baseline.
std::string svg_text(double x, double y, const std::string& text, SvgAnchor anchor, double size = 12.0,
                     const std::string& colour = svg_dark_grey);

/// Grid lines at the labelled ticks of both axes.
std::string svg_grid(const Plot& plot);

/// Frame, ticks, labels and titles of the plot. They take 36 px below the frame, 20 px above it, and up_title_distance
/// + 12 px to its left.
std::string svg_axes(const Plot& plot);

/// One round dot of this diameter [px] per point, all in one path, which keeps the file small.
std::string svg_dots(const Plot& plot, const std::vector<PlotPoint>& points, const std::string& colour,
                     double diameter);

/// An arrow whose head has a constant size [px], but at most half the length of the arrow. There is no head if both
/// points coincide.
std::string svg_arrow(const Plot& plot, PlotPoint from, PlotPoint to, const std::string& colour);

/// Legend: the labels of series 0, 1, ... next to dots of their colours (svg_series_colour), in one row. The first dot
/// is at x; y is the baseline of the labels.
std::string svg_legend(double x, double y, const std::vector<std::string>& labels);

} // namespace multipath
