#include "commands/commands.h"

#include "base/errors.h"
#include "cli/options/choices.h"

namespace multipath {

std::vector<Command> commands()
{
    std::vector<Command> all = {solve_command(),   render_command(),  merge_command(),   check_command(),
                                study_command(),   paper_command(),   compare_command(), points_command(),
                                explain_command(), selftest_command()};
    all.push_back(help_command(all));
    return all;
}

Command command_named(const std::string& name)
{
    std::vector<std::string> names;
    for (const Command& command : commands()) {
        if (command.table.name == name)
            return command;
        names.emplace_back(command.table.name);
    }
    throw UsageError((name[0] == '-' ? "unknown option " : "unknown command ") + quoted_argument(name) +
                     did_you_mean(name, names));
}

std::vector<CommandTable> tables_of(const std::vector<Command>& commands)
{
    std::vector<CommandTable> tables;
    for (const Command& command : commands)
        tables.push_back(command.table);
    return tables;
}

} // namespace multipath
