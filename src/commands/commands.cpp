#include "commands/commands.h"

#include "base/errors.h"
#include "base/lists.h"

#include <algorithm>

namespace multipath {

std::vector<Command> commands()
{
    return {solve_command(),   render_command(),   merge_command(),   check_command(),
            study_command(),   paper_command(),    compare_command(), points_command(),
            explain_command(), selftest_command(), help_command()};
}

Command command_named(const std::string& name)
{
    const std::vector<Command> all = commands();
    if (name[0] == '-')
        throw UsageError("unknown option " + quoted_argument(name));
    require_choice("command", name, names_of(tables_of(all)));
    return *std::find_if(all.begin(), all.end(), [&](const Command& command) { return command.table.name == name; });
}

std::vector<CommandTable> tables_of(const std::vector<Command>& commands)
{
    return mapped(commands, &Command::table);
}

} // namespace multipath
