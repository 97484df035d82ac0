#pragma once

#include "study/curve.h"

#include <string>
#include <vector>

namespace multipath {

/// Abscissa of a convergence plot.
enum class Abscissa {
    lines,  ///< of an execution, local and global
    seconds ///< [s] processor time of an execution on one thread
};

/// Plots the relative MSE (1) of a study as an SVG document with logarithmic axes. Every point is a mark with an error
/// bar of one standard error to either side, unless the mark hides it. Every curve has its power law (2), with the
/// slope and its 95 % interval; against seconds the law is fitted to the seconds. The law is fitted to the points above
/// the reference; the others are hollow. Points whose error or abscissa is not above 0 are left out. The error of the
/// reference is a dashed line if it is within a decade of the range of the points. Thin lines above the points show the
/// slopes -1 and -1.25. The legend is below the frame. The comments go into the document's description.
std::string convergence_plot(const Study& study, Abscissa against, const std::string& title,
                             const std::vector<std::string>& comments);

} // namespace multipath
