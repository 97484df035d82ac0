#pragma once

#include "study/curve.h"

#include <string>
#include <vector>

namespace multipath {

/// Plots the relative MSE ((1) in docs/equations.md) of a study as an SVG document with two logarithmic axes. Every
/// point is a mark with a bar of one standard error to either side. Points that are not above the reference
/// (CurvePoint::above_reference) are hollow. Points whose error or abscissa is not above 0 are left out. Every curve
/// has the line of its power law (2), fitted to the points above the reference, or, without a law, a dotted line
/// through these points. The legend below the frame states the slope of each law and its 95 % interval. If the abscissa
/// is seconds, the law is fitted to the seconds, provided that they span at least a factor of 4. Two grey lines, which
/// start at the left above all points, show the slopes -1 and -1.25. The comments go into the description of the
/// document.
std::string convergence_plot(const Study& study, Abscissa against, const std::string& title,
                             const std::vector<std::string>& comments);

} // namespace multipath
