#include "cli/commands.h"

namespace multipath {

std::vector<Command> commands()
{
    return {solve_command()};
}

} // namespace multipath
