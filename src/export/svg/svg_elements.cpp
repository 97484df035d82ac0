#include "export/svg/svg_elements.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace multipath {

namespace {

constexpr std::array<const char*, 7> colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                "#222222", "#e69f00", "#56b4e9"};

/// Paths from the mark's place on, in the order of MarkShape.
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

std::string line_attributes(const LineStyle& style)
{
    return svg_stroke(style.colour, svg_number(style.width)) +
           (style.dashes.empty() ? "" : svg_attribute("stroke-dasharray", style.dashes));
}

} // namespace

std::string svg_number(double value)
{
    const double tenths = std::round(10.0 * value);
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), std::fmod(tenths, 10.0) == 0.0 ? "%.0f" : "%.1f", tenths / 10.0 + 0.0);
    return text.data();
}

std::string svg_place(SvgPoint place)
{
    return svg_number(place.x) + " " + svg_number(place.y);
}

std::string svg_escaped(const std::string& text)
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

std::string svg_attribute(const char* name, const std::string& value)
{
    return " " + std::string(name) + "=\"" + value + "\"";
}

std::string svg_stroke(const std::string& colour, const std::string& width)
{
    return svg_attribute("fill", "none") + svg_attribute("stroke", colour) + svg_attribute("stroke-width", width);
}

MarkStyle svg_series_mark(std::size_t series)
{
    return {colours[series % colours.size()], static_cast<MarkShape>(series % outlines.size())};
}

std::string svg_marks(const std::vector<SvgPoint>& places, const MarkStyle& style, bool hollow)
{
    if (places.empty())
        return "";
    std::string shapes;
    for (const SvgPoint place : places)
        shapes += "M" + svg_place(place) + outlines[static_cast<std::size_t>(style.shape)];
    return "<path" + svg_attribute("d", shapes) + svg_attribute("fill", hollow ? "#ffffff" : style.colour) +
           svg_attribute("stroke", hollow ? style.colour : "#ffffff") +
           svg_attribute("stroke-width", hollow ? "1.3" : "0.7") + svg_attribute("stroke-linejoin", "round") + "/>\n";
}

std::string svg_polyline(const std::vector<SvgPoint>& places, const LineStyle& style)
{
    if (places.size() < 2)
        return "";
    std::string shape;
    for (const SvgPoint place : places)
        shape += (shape.empty() ? "M" : "L") + svg_place(place);
    return "<path" + svg_attribute("d", shape) + line_attributes(style) + "/>\n";
}

std::string svg_bars(const std::vector<VerticalBar>& bars, const LineStyle& style)
{
    if (bars.empty())
        return "";
    std::string shape;
    for (const VerticalBar& bar : bars)
        shape += "M" + svg_place({bar.x, bar.top}) + "V" + svg_number(bar.bottom);
    return "<path" + svg_attribute("d", shape) + line_attributes(style) + "/>\n";
}

} // namespace multipath
