#pragma once

#include "cli/options/command_line.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// The words of a text in lines of at most `width` columns, broken at spaces, each with its line feed; a longer word
/// has a line of its own. The first line begins at `column`, which the caller has filled so far; the others with
/// `indent` spaces.
std::string wrapped_text(std::string_view text, std::size_t column, std::size_t indent, std::size_t width);

/// A subject that no single option explains.
struct HelpTopic
{
    std::string_view name;    ///< "scenes"; no command has it
    std::string_view summary; ///< one line, without a full stop
    std::string text;         ///< lines of at most 80 columns
};

/// Purpose of the program, one sentence.
inline const std::string program_summary =
    "multipath computes diffuse global illumination (radiosity) with global lines.";

constexpr std::size_t page_width = 90; ///< [columns] of the help of commands

/// `left` in a column of its own, `right` wrapped beside it, from column `indent` to `width`.
std::string two_columns(const std::string& left, std::string_view right, std::size_t indent,
                        std::size_t width = page_width);

/// The option's help with what the table knows besides in brackets: "(one of 4d, 2d; default 4d)".
std::string option_help(const Option& option);

/// `multipath solve [OPTIONS] SCENE.obj`
std::string usage_line(const CommandTable& table);

/// `try 'multipath solve --help'`; with an empty command name `try 'multipath --help'`.
std::string help_hint(std::string_view command);

/// The answer to `multipath COMMAND --help`: usage, summary, options by group with their defaults, notes.
/// At most 90 columns wide, except for the notes.
std::string help_text(const CommandTable& table);

/// The answer to `multipath --help`.
std::string program_help(const std::vector<CommandTable>& tables, const std::vector<HelpTopic>& topics);

/// One line per command: name and summary, aligned.
std::string command_list(const std::vector<CommandTable>& tables);

/// The manual of the program in the language of `man` (roff with the macros man(7)): every command with its options,
/// then every topic. The same tables give the same bytes: it bears the version, and no date.
std::string man_page(const std::vector<CommandTable>& tables, const std::vector<HelpTopic>& topics);

/// The script that lets bash complete commands, the options of a command, their choices, and files with the extensions
/// that an operand takes. An option's argument called FILE is a file, FOLDER a folder.
std::string bash_completion(const std::vector<CommandTable>& tables);

} // namespace multipath
