#pragma once

#include "cli/options/command_line.h"
#include "radiosity/solve_options.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// The options that decide what a run does, of every command that solves or follows one. `line_count` is the command's
/// own option for the number of all lines of the run; `reuse` is among the methods, and the default, of those commands
/// that can do it; the others take the methods whose lines can be told.
OptionGroup method_option_group(const Option& line_count, bool with_reuse);

/// The same for `solve`.
OptionGroup solve_method_group();

/// `line_count`: the name of that option. Throws UsageError.
SolveOptions read_solve_options(const CommandLine& line, std::string_view line_count);

/// The same without method, sequence, pairing, line order, chords and number of lines.
SolveOptions read_settings(const CommandLine& line);

/// What `--lines auto` means for the scene, "2^21": 2^20, or the power of two that gives each patch 24.
std::string usual_lines(const Scene& scene);

/// Puts it into its place.
void settle_lines(const Scene& scene, CommandLine& line, SolveOptions& options);

// What the words of --chords, --pairing and --line-order stand for.
inline constexpr std::array<NamedValue<Chords>, 2> chords_choices = {
    {{"sphere", Chords::sphere}, {"box", Chords::box}}};
inline constexpr std::array<NamedValue<Pairing>, 2> pairing_choices = {
    {{"4d", Pairing::four_dimensional}, {"2d", Pairing::two_dimensional}}};
inline constexpr std::array<NamedValue<LineOrder>, 2> line_order_choices = {
    {{"shuffled", LineOrder::shuffled}, {"sequence", LineOrder::sequence}}};

/// Options that the method has no use for are mistakes: throws UsageError.
void require_options_with_effect(const CommandLine& line);

/// The same for several methods, of which one must have a use for the option. `given`: what the user wrote of them.
void require_options_with_effect(const CommandLine& line, const std::vector<std::string>& methods,
                                 const std::string& given);

/// The sequence's full name; its absence is the user's mistake (UsageError) with `option`.
std::string checked_sequence_name(const SolveOptions& options, const std::string& option = "--sequence");

} // namespace multipath
