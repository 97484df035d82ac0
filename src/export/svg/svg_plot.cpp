#include "export/svg/svg_plot.h"

#include "base/elementary.h"
#include "base/text_format.h"
#include "export/html_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace multipath {

namespace {

constexpr std::array<const char*, 8> series_colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                       "#222222", "#e69f00", "#56b4e9", "#8b5a2b"};

/// Shapes of marks: path data relative to the mark's centre.
constexpr std::array<const char*, 12> outlines = {
    "m-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0z",
    "m-3.6 -3.6h7.2v7.2h-7.2z",
    "m0 -5l4.6 8h-9.2z",
    "m0 -5l5 5-5 5-5-5z",
    "m0 5l4.6-8h-9.2z",
    "m0 -1.9l2.4-2.4 1.9 1.9-2.4 2.4 2.4 2.4-1.9 1.9-2.4-2.4-2.4 2.4-1.9-1.9 2.4-2.4-2.4-2.4 1.9-1.9z",
    "m-1.4 -4.7h2.8v3.3h3.3v2.8h-3.3v3.3h-2.8v-3.3h-3.3v-2.8h3.3z",
    "m0 -5.4l1.4 3.5 3.7 .2-2.9 2.4 1 3.7-3.2-2.1-3.2 2.1 1-3.7-2.9-2.4 3.7-.2z",
    "m-5 0l8-4.6v9.2z",
    "m-4.4 -4.6h8.8l-3.1 4.6 3.1 4.6h-8.8l3.1-4.6z",
    "m5 0l-8-4.6v9.2z",
    "m-4.6 -4.4l4.6 3.1 4.6-3.1v8.8l-4.6-3.1-4.6 3.1z"};

/// [px] with at most one decimal, to keep files small: a drawing of thousands of points consists mostly of such
/// numbers.
std::string svg_number(double value)
{
    const double tenths = std::round(10.0 * value);
    return format("%.*f", std::fmod(tenths, 10.0) == 0.0 ? 0 : 1, tenths / 10.0 + 0.0);
}

/// Coordinates as text: "12.5 7".
std::string svg_point(SvgPoint point)
{
    return svg_number(point.x) + " " + svg_number(point.y);
}

/// Escapes text for XML. Control characters, which XML forbids, become '?'.
std::string svg_escaped(const std::string& text)
{
    return without_controls(html_escaped(text));
}

/// ` name="value"`; the value is not escaped.
std::string svg_attribute(const char* name, const std::string& value)
{
    return " " + std::string(name) + "=\"" + value + "\"";
}

std::string line_attributes(const LineStyle& style)
{
    return svg_stroke(style.colour, svg_number(style.width)) +
           (style.dashes.empty() ? "" : svg_attribute("stroke-dasharray", style.dashes));
}

/// A text element; `content` is XML.
std::string text_element(double x, double y, const std::string& content, SvgAnchor anchor, double size,
                         const std::string& colour)
{
    constexpr std::array<const char*, 3> anchors = {"start", "middle", "end"};
    return "<text" + svg_attribute("x", svg_number(x)) + svg_attribute("y", svg_number(y)) +
           svg_attribute("text-anchor", anchors[static_cast<std::size_t>(anchor)]) +
           svg_attribute("font-size", svg_number(size)) + svg_attribute("fill", colour) + ">" + content + "</text>\n";
}

/// The label of a tick; the part after a '^' becomes a superscript.
std::string tick_label(double x, double y, const std::string& label, SvgAnchor anchor)
{
    const std::size_t caret = std::min(label.find('^'), label.size());
    std::string content = svg_escaped(label.substr(0, caret));
    if (caret < label.size())
        content += "<tspan dy=\"-4\" font-size=\"8.5\">" + svg_escaped(label.substr(caret + 1)) + "</tspan>";
    return text_element(x, y, content, anchor, 11.0, svg_dark_grey);
}

std::string plot_titles(const Plot& plot)
{
    const double middle = plot.left + 0.5 * plot.width;
    const SvgPoint beside = {plot.left - plot.up_title_distance, plot.top + 0.5 * plot.height};
    return svg_text(middle, plot.top + plot.height + 32.0, plot.across.title, SvgAnchor::middle) + "<g" +
           svg_attribute("transform", "rotate(-90 " + svg_point(beside) + ")") + ">" +
           svg_text(beside.x, beside.y, plot.up.title, SvgAnchor::middle) + "</g>\n" +
           svg_text(middle, plot.top - 8.0, plot.title, SvgAnchor::middle, 13.0);
}

constexpr int most_powers = 14;
constexpr double least_decades = 0.7; // [decades] contains at least two of 1, 2, 5, 10, 20 ... wherever it begins

/// Label of times * 10^exponent: "10^−4", "2·10^6".
std::string label_of(int times, int exponent)
{
    return (times == 1 ? "" : std::to_string(times) + "\u00b7") + (exponent < 0 ? "10^\u2212" : "10^") +
           std::to_string(std::abs(exponent));
}

} // namespace

std::string svg_path(const std::string& shape, const std::string& attributes)
{
    return shape.empty() ? "" : "<path" + svg_attribute("d", shape) + attributes + "/>\n";
}

std::string svg_stroke(const std::string& colour, const std::string& width)
{
    return svg_attribute("fill", "none") + svg_attribute("stroke", colour) + svg_attribute("stroke-width", width);
}

MarkStyle svg_series_mark(std::size_t series)
{
    constexpr std::size_t period = 24; // of colour and shape together
    return {series_colours[series % series_colours.size()], (series + series / period) % outlines.size()};
}

std::string svg_marks(const std::vector<SvgPoint>& points, const MarkStyle& style, bool hollow)
{
    std::string shapes;
    for (const SvgPoint point : points)
        shapes += "M" + svg_point(point) + outlines[style.shape];
    return svg_path(shapes, svg_attribute("fill", hollow ? "#ffffff" : style.colour) +
                                svg_attribute("stroke", hollow ? style.colour : "#ffffff") +
                                svg_attribute("stroke-width", hollow ? "1.3" : "0.7") +
                                svg_attribute("stroke-linejoin", "round"));
}

std::string svg_polyline(const std::vector<SvgPoint>& points, const LineStyle& style)
{
    if (points.size() < 2)
        return "";
    std::string shape;
    for (const SvgPoint point : points)
        shape += (shape.empty() ? "M" : "L") + svg_point(point);
    return svg_path(shape, line_attributes(style));
}

std::string svg_bars(const std::vector<VerticalBar>& bars, const LineStyle& style)
{
    std::string shape;
    for (const VerticalBar& bar : bars)
        shape += "M" + svg_point({bar.x, bar.top}) + "V" + svg_number(bar.bottom);
    return svg_path(shape, line_attributes(style));
}

PlotAxis log_axis(const std::string& title, double low, double high)
{
    if (low > high)
        return log_axis(title, 0.0, 1.0);
    const double room = std::max({0.13, 0.03 * (high - low), 0.5 * (least_decades - (high - low))});
    PlotAxis axis{title, low - room, high + room, {}};
    const int first = static_cast<int>(std::floor(axis.low));
    const int last = static_cast<int>(std::floor(axis.high));
    const int step = 1 + (last - first) / most_powers;
    const bool few_powers = std::floor(axis.high) - std::ceil(axis.low) < 1.0;
    for (int exponent = first; exponent <= last; ++exponent)
        for (int times = 1; times <= (step == 1 ? 9 : 1); ++times) {
            const double value = exponent + elementary::log10(times);
            const bool labelled = times == 1 ? exponent % step == 0 : few_powers && (times == 2 || times == 5);
            if (value < axis.low || value > axis.high)
                continue;
            if (labelled)
                axis.ticks.push_back({value, label_of(times, exponent)});
            else
                axis.minor_ticks.push_back(value);
        }
    return axis;
}

std::string svg_series_colour(std::size_t series)
{
    return series_colours[series % 4];
}

std::string svg_ramp_colour(double share)
{
    constexpr std::array<double, 3> dark_blue = {10, 40, 110};
    constexpr std::array<double, 3> orange = {240, 150, 20};
    const auto mixed = [&](std::size_t i) {
        return static_cast<unsigned>(std::lround(dark_blue[i] + share * (orange[i] - dark_blue[i]))) & 0xffu;
    };
    return format("#%02x%02x%02x", mixed(0), mixed(1), mixed(2));
}

std::string svg_head(double width, double height, const std::string& title, const std::vector<std::string>& comments)
{
    std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + svg_attribute("width", svg_number(width)) +
                       svg_attribute("height", svg_number(height)) +
                       svg_attribute("viewBox", "0 0 " + svg_number(width) + " " + svg_number(height)) +
                       svg_attribute("font-family", "sans-serif") + ">\n<title>" + svg_escaped(title) +
                       "</title>\n<desc>";
    for (const std::string& comment : comments)
        text += svg_escaped(comment) + "\n";
    return text + "</desc>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

std::string svg_end()
{
    return "</svg>\n";
}

std::string svg_text(double x, double y, const std::string& text, SvgAnchor anchor, double size,
                     const std::string& colour)
{
    return text_element(x, y, svg_escaped(text), anchor, size, colour);
}

SvgPoint Plot::at(PlotPoint point) const
{
    return {left + width * (point.x - across.low) / (across.high - across.low),
            top + height * (up.high - point.y) / (up.high - up.low)};
}

std::string svg_grid(const Plot& plot)
{
    std::string lines;
    for (const PlotTick& tick : plot.across.ticks)
        lines += "M" + svg_point({plot.at({tick.value, 0.0}).x, plot.top}) + "v" + svg_number(plot.height);
    for (const PlotTick& tick : plot.up.ticks)
        lines += "M" + svg_point({plot.left, plot.at({0.0, tick.value}).y}) + "h" + svg_number(plot.width);
    return svg_path(lines, svg_stroke("#e4e4e4", "1"));
}

std::string svg_axes(const Plot& plot)
{
    const double right = plot.left + plot.width;
    const double bottom = plot.top + plot.height;
    const auto across_tick = [&](double value) { return "M" + svg_point({plot.at({value, 0.0}).x, bottom}); };
    const auto up_tick = [&](double value) { return "M" + svg_point({plot.left, plot.at({0.0, value}).y}); };
    std::string lines = "M" + svg_point({plot.left, plot.top}) + "H" + svg_number(right) + "V" + svg_number(bottom) +
                        "H" + svg_number(plot.left) + "Z";
    std::string labels;
    for (const PlotTick& tick : plot.across.ticks) {
        lines += across_tick(tick.value) + "v4";
        labels += tick_label(plot.at({tick.value, 0.0}).x, bottom + 16.0, tick.label, SvgAnchor::middle);
    }
    for (const PlotTick& tick : plot.up.ticks) {
        lines += up_tick(tick.value) + "h-4";
        labels += tick_label(plot.left - 7.0, plot.at({0.0, tick.value}).y + 4.0, tick.label, SvgAnchor::end);
    }
    for (const double value : plot.across.minor_ticks)
        lines += across_tick(value) + "v2";
    for (const double value : plot.up.minor_ticks)
        lines += up_tick(value) + "h-2";
    return svg_path(lines, svg_stroke("#555555", "1")) + labels + plot_titles(plot);
}

std::string svg_dots(const Plot& plot, const std::vector<PlotPoint>& points, const std::string& colour, double diameter)
{
    std::string dots;
    for (const PlotPoint& p : points)
        dots += "M" + svg_point(plot.at(p)) + "h0"; // a line of length 0 with round caps
    return svg_path(dots, svg_attribute("stroke-linecap", "round") + svg_stroke(colour, svg_number(diameter)));
}

std::string svg_arrow(const Plot& plot, PlotPoint from, PlotPoint to, const std::string& colour)
{
    const auto [x, y] = plot.at(to);
    const double run = x - plot.at(from).x;
    const double rise = y - plot.at(from).y;
    const double length = elementary::hypot(run, rise);
    std::string shape = "M" + svg_point({x - run, y - rise}) + "L" + svg_point({x, y});
    if (length > 0.0) {
        const double back = std::min(6.0, 0.5 * length) / length;
        const double aside = 0.45 * back;
        shape += "M" + svg_point({x - back * run - aside * rise, y - back * rise + aside * run}) + "L" +
                 svg_point({x, y}) + "L" + svg_point({x - back * run + aside * rise, y - back * rise - aside * run});
    }
    return svg_path(shape, svg_stroke(colour, "0.9"));
}

std::string svg_legend(double x, double y, const std::vector<std::string>& labels)
{
    std::string text;
    for (std::size_t series = 0; series < labels.size(); ++series) {
        text += "<circle" + svg_attribute("cx", svg_number(x)) + svg_attribute("cy", svg_number(y - 4.0)) +
                svg_attribute("r", "4") + svg_attribute("fill", svg_series_colour(series)) + "/>\n";
        text += svg_text(x + 9.0, y, labels[series], SvgAnchor::start);
        x += 26.0 + 7.0 * static_cast<double>(labels[series].size()); // generous estimate, since fonts differ
    }
    return text;
}

} // namespace multipath
