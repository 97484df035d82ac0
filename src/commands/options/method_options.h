#pragma once

#include "cli/options/command_line.h"
#include "cli/options/option_table.h"
#include "radiosity/solve_options.h"

#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// The options that decide what a run does, of every command that solves or follows one. `line_count` is the command's
/// own option for the number of all lines of the run; `reuse` is among the methods, and the default, of those commands
/// that can do it; the others take the methods whose lines can be told.
OptionGroup method_option_group(const Option& line_count, bool with_reuse);

/// `line_count`: the name of that option. Throws UsageError.
SolveOptions read_solve_options(const CommandLine& line, std::string_view line_count);

/// The same without method, sequence, pairing, line order, chords and number of lines.
SolveOptions read_settings(const CommandLine& line);

/// The choices of --chords.
inline constexpr std::string_view sphere_chords = "sphere";
inline constexpr std::string_view box_chords = "box";

std::string chords_name(Chords chords);

/// Words that the tables allow.
Pairing pairing_named(std::string_view name);
Chords chords_named(std::string_view name);
LineOrder line_order_named(std::string_view name);

/// Options that the method has no use for are mistakes: throws UsageError.
void require_options_with_effect(const CommandLine& line);

/// The same for several methods, of which one must have a use for the option. `given`: what the user wrote of them.
void require_options_with_effect(const CommandLine& line, const std::vector<std::string>& methods,
                                 const std::string& given);

/// The sequence's full name; its absence is the user's mistake (UsageError) with `option`.
std::string checked_sequence_name(const SolveOptions& options, const std::string& option = "--sequence");

} // namespace multipath
