#pragma once

#include "cli/option_table.h"

#include <string>
#include <vector>

namespace multipath {

/// `multipath solve [OPTIONS] SCENE.obj`
std::string usage_line(const CommandTable& table);

/// `try 'multipath solve --help'`; with an empty command name `try 'multipath --help'`.
std::string help_hint(std::string_view command);

/// The answer to `multipath COMMAND --help`: usage, summary, options by group with their defaults, notes.
/// At most 90 columns wide, except for the notes.
std::string help_text(const CommandTable& table);

/// One line per command: name and summary, aligned.
std::string command_list(const std::vector<CommandTable>& tables);

} // namespace multipath
