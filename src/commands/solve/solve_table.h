#pragma once

#include "cli/options/command_line.h"

namespace multipath {

/// The table of the command `solve`. Other commands also read and write command lines of `solve`: states and tables of
/// patches record them.
CommandTable solve_table();

} // namespace multipath
