#pragma once

#include "cli/options/command_line.h"
#include "radiosity/run/solve_options.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// The options of the method, for every command that solves or traces a run. `line_count`: the command's own option for
/// the total number of lines. `with_reuse`: all methods are choices, `reuse` is the default, and --direct, --denoise
/// and
/// --important are included. Without it, only methods whose lines `explain` can trace are choices, and `first-shot` is
/// the default.
OptionGroup method_option_group(const Option& line_count, bool with_reuse);

/// The options of the method for `solve`, with `reuse` and --lines.
OptionGroup solve_method_group();

/// Reads --memory and the options of the method. `line_count`: name of the option for the total number of lines. The
/// options that depend on the scene are left out: `--lines auto` is for settle_lines(), --important for the caller.
/// Throws UsageError.
SolveOptions read_solve_options(const CommandLine& line, std::string_view line_count);

/// The number of lines that `--lines auto` takes for the scene, as text such as "2^21": the smallest power of two that
/// is at least 2^20 and gives each patch at least 24 lines.
std::string usual_lines(const Scene& scene);

/// Sets the number of lines to usual_lines() if the command line says `--lines auto`.
void settle_lines(const Scene& scene, const CommandLine& line, SolveOptions& options);

// Values of --chords, --pairing and --line-order.
inline constexpr std::array<NamedValue<Chords>, 2> chords_choices = {
    {{"sphere", Chords::sphere}, {"box", Chords::box}}};
inline constexpr std::array<NamedValue<Pairing>, 2> pairing_choices = {
    {{"4d", Pairing::four_dimensional}, {"2d", Pairing::two_dimensional}}};
inline constexpr std::array<NamedValue<LineOrder>, 2> line_order_choices = {
    {{"shuffled", LineOrder::shuffled}, {"sequence", LineOrder::sequence}}};

/// Throws UsageError if an option of the methods is given that has no effect with the method of the command line. An
/// option with its default value is accepted.
void require_options_with_effect(const CommandLine& line);

/// The same for several methods: every option must have an effect with at least one of them. `given`: what the user
/// wrote, such as "--methods local,global", for the message.
void require_options_with_effect(const CommandLine& line, const std::vector<std::string>& methods,
                                 const std::string& given);

/// The full name of the sequence in the options, or of its randomised form. Throws UsageError if the sequence cannot be
/// made; the message begins with `option`.
std::string checked_sequence_name(const SolveOptions& options, const std::string& option = "--sequence",
                                  bool randomised = false);

} // namespace multipath
