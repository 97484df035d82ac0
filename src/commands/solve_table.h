#pragma once

#include "cli/option_table.h"

namespace multipath {

/// The command line of `solve`, which other commands continue.
CommandTable solve_table();

/// The options that say how it solves.
OptionGroup solve_method_group();

} // namespace multipath
