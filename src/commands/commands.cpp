#include "commands/commands.h"

namespace multipath {

std::vector<Command> commands()
{
    return {solve_command(),  render_command(),  merge_command(),   check_command(),
            study_command(),  paper_command(),   compare_command(), reproduce_command(),
            points_command(), explain_command(), selftest_command()};
}

} // namespace multipath
