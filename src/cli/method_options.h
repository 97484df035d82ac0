#pragma once

#include "cli/command_line.h"
#include "cli/option_table.h"
#include "radiosity/solve_options.h"

#include <string>
#include <string_view>

namespace multipath {

/// The options that decide what a run does, of every command that solves or follows one. `line_count` is the command's
/// own option for the number of all lines of the run; `reuse` is among the methods, and the default, of those commands
/// that can do it.
OptionGroup method_option_group(const Option& line_count, bool with_reuse);

/// `line_count`: the name of that option. Throws UsageError.
SolveOptions read_solve_options(const CommandLine& line, std::string_view line_count);

/// Options that the method has no use for are mistakes: throws UsageError.
void require_options_with_effect(const CommandLine& line);

/// The sequence's full name; its absence is the user's mistake (UsageError).
std::string checked_sequence_name(const SolveOptions& options);

} // namespace multipath
