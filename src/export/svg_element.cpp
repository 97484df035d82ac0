#include "export/svg_element.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace multipath {

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

} // namespace multipath
