#pragma once

#include "study/curve.h"

#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// A number with this many decimals. A negative one begins with a minus sign (U+2212), not a hyphen.
std::string fixed(double value, int decimals);

/// "1.2·10⁻⁴"
std::string scientific(double value);

/// "−1.100 ± 0.020": the slope and half the width of its 95 % interval; "none" without a law.
std::string slope_words(const std::optional<PowerLaw>& law);

/// Label of a curve: "first-shot, sobol", or only the name for another program's curve. Pairing, chords and line order
/// are appended if another curve of the same method differs in them; the pairing also if it is not 4d.
std::string curve_label(const Study& study, const Curve& curve);

/// Reads the curve of another program: a table with one row per point and the columns `lines` and `relative_mse` (1);
/// optional columns are `standard_error` (of relative_mse) and `seconds`. Throws InputError for a file that is no such
/// table, for numbers that are not above 0, and for lines that do not increase.
Curve read_curve(const std::string& path, const std::string& name);

/// A report for the terminal: every point, and the slope of each curve with its standard error.
std::string study_text(const Study& study);

/// A table with one row per point: method, sequence, lines, local_lines, global_lines, mse [W^2/m^4], relative_mse,
/// standard_error (of relative_mse; empty with one execution), seconds, slope and slope_error of the curve (empty
/// without a fit), in_fit (1 or 0), replicates, pairing, chords and line_order.
std::string study_csv(const Study& study, const std::vector<std::string>& comments);

/// Reads a study that study_csv() wrote, and repeats the fits. Throws InputError for a file that is no such table.
Study read_study(const std::string& path);

} // namespace multipath
