#pragma once

#include "explain/line_trace.h"

#include <string>
#include <vector>

// Words for the told lines: plain text of at most 110 columns.

namespace multipath {

/// Stands for a space at which no line ends.
constexpr char tied = '\x1f';

/// Breaks a text between words and writes tied ones with a space; its first line begins with `first` spaces, the others
/// with `others`.
std::string wrapped(const std::string& text, std::size_t first, std::size_t others);

/// "0.7", or "(0.7, 0.6, 0.5)" where the channels differ; tied, as are the watts.
std::string colour_text(Rgb c);
/// The same in watts: "0.7 W".
std::string watts(Rgb power);

/// "(1.234, 0.500, -2.000)"
std::string point_text(Vec3 p);

/// "table_top (line 12)", as `check` names it; the material stands in for a missing name.
std::string surface_name(const Scene& scene, std::uint32_t surface);
/// "patch 12 of table_top (line 12)"; "its back" is said where both sides have patches.
std::string patch_name(const Scene& scene, std::uint32_t patch);

/// "item 17 = (0.1, 0.2, 0.3, 0.4)"
std::string origin_text(const LineOrigin& origin);

/// A table of the meetings, numbered from 1, in order.
std::string meetings_table(const Scene& scene, const std::vector<Meeting>& meetings);

} // namespace multipath
