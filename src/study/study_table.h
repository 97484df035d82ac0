#pragma once

#include "study/curve.h"

#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// Formats a number with this many decimals. A negative number begins with a minus sign (U+2212) instead of a hyphen,
/// unless all its digits are 0.
std::string fixed(double value, int decimals);

/// Formats the slope of a law and half the width of its 95 % interval: "−1.100 ± 0.020". "none" if there is no law.
std::string slope_words(const std::optional<PowerLaw>& law);

/// Formats a number with its interval: "0.96 (0.93 to 1.00)"; without one that is unknown.
std::string interval_words(const Estimate& estimate);

/// Formats the probability of the law: "; p = 0.40". Empty if it is unknown.
std::string fit_words(const RatioFindings& found);

/// Label of a curve: method and sequence, such as "first-shot, sobol"; for the curve of another program only the name.
/// Pairing, chords and line order are each appended if another curve of the same method differs in it.
std::string curve_label(const Study& study, const Curve& curve);

/// Reads the curve of another program, called `name`, and fits it. The file is a table with one row per point and the
/// columns `lines` and `relative_mse` [1]; optional columns are `standard_error` (of relative_mse; a field may be
/// empty) and `seconds`. Throws InputError for a file that is no such table or has no row; for lines, relative_mse or
/// seconds that are not above 0; and for lines that are not whole numbers or do not increase.
Curve read_curve(const std::string& path, const std::string& name);

/// Formats a study for the terminal: every point, and the slope of each curve with its standard error and its 95 %
/// interval.
std::string study_text(const Study& study);

/// Formats a study as CSV with one row per point and the columns method, sequence, lines, local_lines, global_lines,
/// mse [W^2/m^4], relative_mse [1], standard_error (of relative_mse; empty with one execution), seconds [s], slope and
/// slope_error (of the curve; empty without a fit), in_fit (1 if the fit uses the point, else 0), replicates (number of
/// executions), pairing, chords and line_order; if the study varies the ratio or the threshold, also that, and the rule
/// that chose it (auto or measured, for a ratio). The comments come first.
std::string study_csv(const Study& study, const std::vector<std::string>& comments);

} // namespace multipath
