#include "commands/commands.h"

namespace multipath {

std::vector<Command> commands()
{
    std::vector<Command> all = {solve_command(),   render_command(),  merge_command(),   check_command(),
                                study_command(),   paper_command(),   compare_command(), points_command(),
                                explain_command(), selftest_command()};
    all.push_back(help_command(all));
    return all;
}

std::vector<CommandTable> tables_of(const std::vector<Command>& commands)
{
    std::vector<CommandTable> tables;
    for (const Command& command : commands)
        tables.push_back(command.table);
    return tables;
}

} // namespace multipath
