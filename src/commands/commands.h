#pragma once

#include "cli/options/command_line.h"
#include "cli/options/help_text.h"
#include "study/curve.h"

#include <string>
#include <vector>

namespace multipath {

/// A command of the program: its table, and the function that runs it. The function returns the exit code 0,
/// exit_failed or exit_interrupted.
struct Command
{
    CommandTable table;
    int (*run)(const CommandLine& line);
};

/// All commands, in the order of the help.
std::vector<Command> commands();

/// The command of this name. Throws UsageError if there is none.
Command command_named(const std::string& name);

/// The tables of the commands, in the same order.
std::vector<CommandTable> tables_of(const std::vector<Command>& commands);

/// All topics of `multipath help`, in reading order.
std::vector<HelpTopic> help_topics();

Command solve_command();
Command render_command();
Command merge_command();
Command check_command();
Command compare_command();
Command study_command();
/// Carries out a command line of `study` and returns its result.
Study study_of(const CommandLine& line);
Command paper_command();
Command points_command();
Command explain_command();
Command selftest_command();
Command help_command();

} // namespace multipath
