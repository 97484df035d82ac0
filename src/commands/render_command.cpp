#include "base/errors.h"
#include "cli/files/standard_streams.h"
#include "commands/commands.h"
#include "commands/options/scene_options.h"
#include "commands/solve/formats.h"
#include "commands/solve/solve_job.h"

namespace multipath {

namespace {

int run_render(const CommandLine& line)
{
    for (const std::string& name : line.all("output"))
        if (kind_of(name) == FormatKind::state)
            throw UsageError("--output: render writes no states; expected a picture, mesh or table, got " +
                             quoted_argument(name));
    const SavedRun saved = read_saved_run(line.operands()[0]);
    SavedJob wanted = open_saved_job(line, saved.description, line.operands()[0]);
    const Solution solution = finished_solution(saved, wanted.scene);
    print_note(write_outputs(wanted.outputs, wanted.job, wanted.scene, solution, ""));
    return 0;
}

} // namespace

Command render_command()
{
    return {{"render",
             "make other pictures, meshes and tables from the state of a run, without solving again",
             {"STATE", 1, 1},
             {without_options(solution_output_group(), {"json", "verbose"}),
              picture_option_group(),
              {"Computation", {threads_option()}}},
             "  multipath solve room.obj --lines 2^24 --state room.state\n"
             "  multipath render room.state --eye 1,1,5 --target 2,1,0 --exposure 2 -o door.png\n"},
            run_render};
}

} // namespace multipath
