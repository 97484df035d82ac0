#pragma once

#include "study/curve.h"

#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// A number with so many decimals, with a minus sign and not a hyphen.
std::string fixed(double value, int decimals);

/// "1.2·10⁻⁴"
std::string scientific(double value);

/// "−1.10 ± 0.02", with the half width of the 95 % interval; "none" without a law.
std::string slope_words(const std::optional<PowerLaw>& law);

/// Label of a curve: "first-shot, sobol"; that of another program has its name alone. Chords and line order follow
/// where another curve of the same method has other ones, the pairing also if it is not 4d.
std::string curve_label(const Study& study, const Curve& curve);

/// The curve of another program: a table with the columns `lines` and `relative_mse` (1), one row per point; and, if it
/// has them, `standard_error` of the latter and `seconds`. Throws InputError for a file that is no such table, for
/// numbers that are not above 0, and for lines that do not increase.
Curve read_curve(const std::string& path, const std::string& name);

/// A report to read: every point, and the slope of each curve with its standard error.
std::string study_text(const Study& study);

/// One row per point: method, sequence, lines, local_lines, global_lines, mse [W^2/m^4], relative_mse, standard_error
/// (of relative_mse), seconds, slope and slope_error of the curve (empty without a fit), and besides whether the point
/// is part of the fit, replicates, pairing, chords and line order.
std::string study_csv(const Study& study, const std::vector<std::string>& comments);

/// A study as study_csv() wrote it; the fits are made anew. Throws InputError for a file that is no such table.
Study read_study(const std::string& path);

} // namespace multipath
