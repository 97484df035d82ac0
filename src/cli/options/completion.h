#pragma once

#include "cli/options/option_table.h"

#include <string>
#include <vector>

namespace multipath {

/// The script that lets bash complete commands, the options of a command, their choices, and files with the extensions
/// that an operand takes. An option's argument called FILE is a file, FOLDER a folder. Hidden options are left out.
std::string bash_completion(const std::vector<CommandTable>& tables);

} // namespace multipath
