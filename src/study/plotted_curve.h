#pragma once

#include "export/svg_marks.h"
#include "export/svg_plot.h"
#include "study/convergence_plot.h"

#include <optional>
#include <vector>

namespace multipath {

/// One standard error to either side of a point; coordinates are decimal logarithms.
struct ErrorBar
{
    PlotPoint middle;
    double low; ///< minus infinity if the error reaches down to 0
    double high;
};

/// A curve as a convergence plot shows it; coordinates are decimal logarithms.
struct PlottedCurve
{
    MarkStyle style;
    std::vector<PlotPoint> fitted; ///< points above the reference
    std::vector<PlotPoint> others;
    std::vector<ErrorBar> bars;  ///< one per point
    std::optional<PowerLaw> law; ///< against the plot's abscissa
    std::vector<PlotPoint> line; ///< of the law, over the fitted points; empty without one
};

/// The curve with the marks of the series; only points whose error and abscissa are above 0 have a place.
PlottedCurve plotted_curve(const Curve& curve, Abscissa against, std::size_t series);

} // namespace multipath
