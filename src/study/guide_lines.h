#pragma once

#include "export/clear_place.h"
#include "export/svg_plot.h"

#include <string>
#include <vector>

namespace multipath {

/// Two thin lines from one point, of slopes -1 (random lines) and -1.25 (the best that stratified sampling does in four
/// dimensions), as long as there is room for, where they are farthest from the obstacles [px]. Both axes of the plot
/// are decimal logarithms.
std::string guide_lines(const Plot& plot, const std::vector<SvgPoint>& obstacles);

struct LabelledLevel
{
    std::string text;             ///< SVG
    std::vector<SvgPoint> points; ///< of the line and the label, obstacles to others
};

/// A horizontal dashed line at a value of the plot's axis up, with a label above or below it, at its left or right end,
/// wherever the obstacles [px] are farthest.
LabelledLevel labelled_level(const Plot& plot, double level, const std::string& label,
                             const std::vector<SvgPoint>& obstacles);

} // namespace multipath
