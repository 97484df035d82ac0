#pragma once

#include "cli/options/help_text.h"
#include "cli/options/option_table.h"

#include <string>
#include <vector>

namespace multipath {

/// The manual of the program in the language of `man` (roff with the macros man(7)): every command with its options,
/// then every topic. The same tables give the same bytes: it bears the version, and no date.
std::string man_page(const std::vector<CommandTable>& tables, const std::vector<HelpTopic>& topics);

} // namespace multipath
