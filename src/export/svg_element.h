#pragma once

#include <string>

// What the elements of an SVG drawing are written with.

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

} // namespace multipath
