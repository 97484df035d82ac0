#pragma once

#include "cli/command_line.h"
#include "cli/option_table.h"
#include "parallel/run_control.h"

#include <string>

namespace multipath {

/// Whether and where the state of a run is kept, what it goes on from, and which share of the work it does.
struct StateOptions
{
    std::string state;        ///< file; empty: not kept
    std::string from;         ///< state to go on from; empty: it begins anew
    double save_every = 60.0; ///< [s]
    Share share;
};

OptionGroup state_option_group();

/// Throws UsageError; InputError for a state that exists where none is to be resumed: it would be lost.
StateOptions read_state_options(const CommandLine& line);

} // namespace multipath
