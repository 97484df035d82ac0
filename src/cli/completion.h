#pragma once

#include "cli/option_table.h"

#include <string>
#include <string_view>
#include <vector>

// Scripts that let a shell complete commands, the options of a command, their choices, and files with the extensions
// that an operand takes. An option's argument called FILE is a file, FOLDER a folder. Hidden options are left out.

namespace multipath {

std::string bash_completion(const std::vector<CommandTable>& tables);
std::string zsh_completion(const std::vector<CommandTable>& tables);
std::string fish_completion(const std::vector<CommandTable>& tables);

} // namespace multipath
