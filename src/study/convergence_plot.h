#pragma once

#include "study/curve.h"

#include <string>
#include <vector>

namespace multipath {

/// Abscissa of a convergence plot.
enum class Abscissa {
    lines,  ///< of an execution, both kinds together
    seconds ///< [s] of an execution on one thread
};

/// The relative MSE (1) of a study as an SVG document, both axes logarithmic: a mark per point with a bar from one
/// standard error below to one above where the mark does not hide it, and the curve's power law (2) with its slope and
/// the 95 % interval of that. Against seconds the law is fitted in these coordinates, through the points above the
/// reference; the others are hollow. Points whose error or abscissa is not above 0 have no place and are left out. The
/// error of the reference is a dashed line if it is at most a decade outside the range of the points. Thin lines above
/// the points show the slopes -1 and -1.25, and the legend stands below the frame. The comments go into the document's
/// description.
std::string convergence_plot(const Study& study, Abscissa against, const std::string& title,
                             const std::vector<std::string>& comments);

} // namespace multipath
