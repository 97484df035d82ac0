#pragma once

#include "cli/command_line.h"
#include "cli/option_table.h"
#include "study/convergence.h"

#include <string>
#include <vector>

namespace multipath {

/// The options that say which curves a study has: lists of methods, sequences, pairings, chords and line orders.
OptionGroup study_curve_options();

/// One curve for each combination of the lists, without those that differ in nothing, such as chords of a method
/// without global lines. Throws UsageError for an unknown name, one named twice, and options without effect.
std::vector<CurvePlan> read_curves(const CommandLine& line);

/// The entries of a list with commas; one that begins with a digit belongs to the entry before if that has a colon, as
/// in "sobol,halton:2,7,3,5".
std::vector<std::string> split_list(const std::string& text);

} // namespace multipath
