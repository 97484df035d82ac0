#pragma once

#include "cli/option_table.h"

#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// All options of a command that its help shows, and --help.
std::vector<Option> shown_options(const CommandTable& table);

bool takes_file(const Option& option);
bool takes_folder(const Option& option);

/// What a help says before its first full stop, colon or semicolon.
std::string_view first_phrase(std::string_view help);

/// Words with the separator between them.
std::string joined(const std::vector<std::string_view>& words, std::string_view separator);

} // namespace multipath
