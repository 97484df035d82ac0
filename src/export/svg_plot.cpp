#include "export/svg_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace multipath {

namespace {

constexpr std::array<const char*, 4> series_colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7"};

/// [px] with one decimal, without a trailing ".0": a drawing of thousands of points is mostly such numbers.
std::string number(double value)
{
    const double tenths = std::round(10.0 * value);
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), std::fmod(tenths, 10.0) == 0.0 ? "%.0f" : "%.1f", tenths / 10.0 + 0.0);
    return text.data();
}

/// Text as XML holds it. Control characters, which XML forbids, become '?'.
std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text)
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else
            result += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    return result;
}

double place_across(const Plot& plot, double value)
{
    return plot.left + plot.width * (value - plot.across.low) / (plot.across.high - plot.across.low);
}

double place_up(const Plot& plot, double value)
{
    return plot.top + plot.height * (plot.up.high - value) / (plot.up.high - plot.up.low);
}

std::string place(double x, double y)
{
    return number(x) + " " + number(y);
}

std::string attribute(const char* name, const std::string& value)
{
    return " " + std::string(name) + "=\"" + value + "\"";
}

std::string stroke(const std::string& colour, const char* width)
{
    return attribute("fill", "none") + attribute("stroke", colour) + attribute("stroke-width", width);
}

} // namespace

std::string svg_series_colour(std::size_t series)
{
    return series_colours[series % series_colours.size()];
}

std::string svg_ramp_colour(double share)
{
    constexpr std::array<double, 3> dark_blue = {10, 40, 110};
    constexpr std::array<double, 3> orange = {240, 150, 20};
    std::array<char, 8> text{};
    const auto mixed = [&](std::size_t i) {
        return static_cast<unsigned>(std::lround(dark_blue[i] + share * (orange[i] - dark_blue[i]))) & 0xffu;
    };
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", mixed(0), mixed(1), mixed(2));
    return text.data();
}

std::string svg_head(double width, double height, const std::string& title, const std::vector<std::string>& comments)
{
    std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", number(width)) +
                       attribute("height", number(height)) +
                       attribute("viewBox", "0 0 " + number(width) + " " + number(height)) +
                       attribute("font-family", "sans-serif") + ">\n<title>" + escaped(title) + "</title>\n<desc>";
    for (const std::string& comment : comments)
        text += escaped(comment) + "\n";
    return text + "</desc>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

std::string svg_end()
{
    return "</svg>\n";
}

std::string svg_text(double x, double y, const std::string& text, SvgAnchor anchor, double size)
{
    constexpr std::array<const char*, 3> anchors = {"start", "middle", "end"};
    return "<text" + attribute("x", number(x)) + attribute("y", number(y)) +
           attribute("text-anchor", anchors[static_cast<std::size_t>(anchor)]) + attribute("font-size", number(size)) +
           attribute("fill", "#222222") + ">" + escaped(text) + "</text>\n";
}

std::string svg_axes(const Plot& plot)
{
    const double right = plot.left + plot.width;
    const double bottom = plot.top + plot.height;
    std::string lines =
        "M" + place(plot.left, plot.top) + "H" + number(right) + "V" + number(bottom) + "H" + number(plot.left) + "Z";
    std::string labels;
    for (const PlotTick& tick : plot.across.ticks) {
        const double x = place_across(plot, tick.value);
        lines += "M" + place(x, bottom) + "v4";
        labels += svg_text(x, bottom + 16.0, tick.label, SvgAnchor::middle, 11.0);
    }
    for (const PlotTick& tick : plot.up.ticks) {
        const double y = place_up(plot, tick.value);
        lines += "M" + place(plot.left, y) + "h-4";
        labels += svg_text(plot.left - 7.0, y + 4.0, tick.label, SvgAnchor::end, 11.0);
    }
    const double middle_up = plot.top + 0.5 * plot.height;
    const std::string turned = "<g" + attribute("transform", "rotate(-90 " + place(plot.left - 34.0, middle_up) + ")") +
                               ">" + svg_text(plot.left - 34.0, middle_up, plot.up.title, SvgAnchor::middle) + "</g>\n";
    return "<path" + attribute("d", lines) + stroke("#555555", "1") + "/>\n" + labels +
           svg_text(plot.left + 0.5 * plot.width, bottom + 32.0, plot.across.title, SvgAnchor::middle) + turned +
           svg_text(plot.left + 0.5 * plot.width, plot.top - 8.0, plot.title, SvgAnchor::middle, 13.0);
}

std::string svg_dots(const Plot& plot, const std::vector<PlotPoint>& points, const std::string& colour, double diameter)
{
    std::string dots;
    for (const PlotPoint& p : points)
        dots += "M" + place(place_across(plot, p.x), place_up(plot, p.y)) + "h0"; // a line of length 0 with round ends
    return "<path" + attribute("d", dots) + attribute("stroke-linecap", "round") +
           stroke(colour, number(diameter).c_str()) + "/>\n";
}

std::string svg_arrow(const Plot& plot, PlotPoint from, PlotPoint to, const std::string& colour)
{
    const double x = place_across(plot, to.x);
    const double y = place_up(plot, to.y);
    const double run = x - place_across(plot, from.x);
    const double rise = y - place_up(plot, from.y);
    const double length = std::hypot(run, rise);
    std::string shape = "M" + place(x - run, y - rise) + "L" + place(x, y);
    if (length > 0.0) {
        const double back = std::min(6.0, 0.5 * length) / length;
        const double aside = 0.45 * back;
        shape = "M" + place(x - run, y - rise) + "L" + place(x, y) + "M" +
                place(x - back * run - aside * rise, y - back * rise + aside * run) + "L" + place(x, y) + "L" +
                place(x - back * run + aside * rise, y - back * rise - aside * run);
    }
    return "<path" + attribute("d", shape) + stroke(colour, "0.9") + "/>\n";
}

std::string svg_legend(double x, double y, const std::vector<std::string>& labels)
{
    std::string text;
    for (std::size_t series = 0; series < labels.size(); ++series) {
        text += "<circle" + attribute("cx", number(x)) + attribute("cy", number(y - 4.0)) + attribute("r", "4") +
                attribute("fill", svg_series_colour(series)) + "/>\n";
        text += svg_text(x + 9.0, y, labels[series], SvgAnchor::start);
        x += 26.0 + 7.0 * static_cast<double>(labels[series].size()); // a generous guess: fonts differ
    }
    return text;
}

} // namespace multipath
