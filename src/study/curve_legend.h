#pragma once

#include "study/plotted_curve.h"

#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// "slope −1.10 ± 0.01" with the 95 % interval, three decimals where two would leave nothing of it; "no slope: points
/// too few or too close" without a law.
std::string slope_text(const std::optional<PowerLaw>& law);

struct CurveLegend
{
    std::string text;    ///< SVG
    double height = 0.0; ///< [px]
};

/// Mark, label and slope of each curve in a row of its own, from `top` on down, in two columns if there are many that
/// fit side by side into `width`.
CurveLegend curve_legend(const std::vector<PlottedCurve>& curves, const std::vector<std::string>& labels, double left,
                         double top, double width);

} // namespace multipath
