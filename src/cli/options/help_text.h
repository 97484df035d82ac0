#pragma once

#include "cli/options/command_line.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// Breaks a text at spaces into lines of at most `width` columns, each with its line feed. A word that is longer gets a
/// line of its own. The first line continues a line that the caller has filled up to `column`; the first word is put
/// there even if it does not fit. The other lines begin with `indent` spaces.
std::string wrapped_text(std::string_view text, std::size_t column, std::size_t indent, std::size_t width);

/// A subject that `multipath help` explains besides the commands.
struct HelpTopic
{
    std::string_view name; ///< "scenes"; differs from all commands
    std::string text;      ///< lines of at most 80 columns
};

/// Purpose of the program, one sentence.
inline const std::string program_summary =
    "multipath computes diffuse global illumination (radiosity) with global lines.";

constexpr std::size_t page_width = 80; ///< [columns] width of the help

/// Two columns of text: `left`, and `right` wrapped into the columns from `indent` to page_width. `right` begins on the
/// next line if `left` is too long.
std::string two_columns(const std::string& left, std::string_view right, std::size_t indent);

/// The output of `multipath COMMAND --help`: usage, summary, options by group with their defaults, notes. All of it
/// is wrapped to 80 columns.
std::string help_text(const CommandTable& table);

/// The output of `multipath --help`.
std::string program_help(const std::vector<CommandTable>& tables, const std::vector<HelpTopic>& topics);

/// The manual page (roff with the macros of man(7)): the help of every command, then every topic, as they are. The page
/// carries the version but no date, so that the same tables give the same bytes.
std::string man_page(const std::vector<CommandTable>& tables, const std::vector<HelpTopic>& topics);

} // namespace multipath
