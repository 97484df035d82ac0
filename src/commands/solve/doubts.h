#pragma once

#include "commands/solve/solve_summary.h"
#include "scene/rgb.h"

#include <string>
#include <vector>

namespace multipath {

/// Reasons to doubt the estimated error of a run, with what helps: each one phrase without a full stop.
std::vector<std::string> doubts_of_error(const SolveSummary& s);

/// Reasons why the result may be wrong or noisy, in the same form: too few lines, lines that do not sample the sources
/// uniformly, unshot or lost power.
std::vector<std::string> doubts_of_result(const SolveSummary& s);

/// [%] A part of the power balance relative to the emitted power; 0 if it is below 0.0005 %.
double percent_of_emitted(const PowerBalance& balance, Rgb part);

/// A share in percent: "0.62 %", "98 %", "150 %".
std::string percent_text(double share);

} // namespace multipath
