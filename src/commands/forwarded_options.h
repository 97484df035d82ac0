#pragma once

#include "cli/command_line.h"
#include "cli/option_table.h"

#include <string>
#include <vector>

namespace multipath {

/// The options that were given on a command line, as words for that of another command that has them, too.
std::vector<std::string> forwarded_options(const CommandTable& table, const CommandLine& line);

/// --output, --quiet and the like, of every command that writes solutions.
OptionGroup solution_output_group();

/// NAME.ppm and NAME.png in the working directory, for a file NAME.*.
std::vector<std::string> default_outputs(const std::string& path);

} // namespace multipath
