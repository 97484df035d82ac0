#pragma once

#include "cli/options/command_line.h"
#include "parallel/run_control.h"

#include <string>

namespace multipath {

/// The command line of `solve`, which other commands continue.
CommandTable solve_table();

/// The options that say how it solves.
OptionGroup solve_method_group();

/// Whether and where the state of a run is kept, what it goes on from, and which share of the work it does.
struct StateOptions
{
    std::string state;        ///< file; empty: not kept
    std::string from;         ///< state to go on from; empty: it begins anew
    double save_every = 60.0; ///< [s]
    Share share;
};

/// Throws UsageError; InputError for a state that exists where none is to be resumed: it would be lost.
StateOptions read_state_options(const CommandLine& line);

} // namespace multipath
