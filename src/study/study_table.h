#pragma once

#include "study/curve.h"

#include <string>
#include <vector>

namespace multipath {

/// "first-shot, sobol": what tells a curve from others. Chords and line order are named where another curve of the same
/// method has other ones, the pairing also if it is not 4d.
std::string curve_label(const Study& study, const Curve& curve);

/// A report to read: every point, and the slope of each curve with its standard error.
std::string study_text(const Study& study);

/// One row per point: method, sequence, lines, local_lines, global_lines, mse [W^2/m^4], relative_mse, standard_error
/// (of relative_mse), seconds, slope and slope_error of the curve (empty without a fit), and besides whether the point
/// is part of the fit, replicates, pairing, chords and line order.
std::string study_csv(const Study& study, const std::vector<std::string>& comments);

} // namespace multipath
