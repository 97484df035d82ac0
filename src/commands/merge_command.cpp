#include "base/errors.h"
#include "base/lists.h"
#include "base/text_format.h"
#include "commands/commands.h"
#include "commands/options/scene_options.h"
#include "commands/solve/formats.h"
#include "commands/solve/solve_job.h"
#include "radiosity/run/shard_sum.h"
#include "radiosity/run/solution.h"

#include <algorithm>
#include <utility>

namespace multipath {

namespace {

/// Sorts the runs by the number of their shard. Throws InputError unless they are all shards of one run.
void require_all_shards(std::vector<SavedRun>& runs)
{
    std::sort(runs.begin(), runs.end(), [](const SavedRun& a, const SavedRun& b) {
        return a.description.shard.number < b.description.shard.number;
    });
    const std::uint64_t of = runs[0].description.shard.of;
    std::vector<std::string> given;
    bool each_once = runs.size() == of;
    for (const SavedRun& run : runs) {
        RunDescription same_shard = run.description;
        same_shard.shard.number = runs[0].description.shard.number;
        require_same_run(runs[0].description, runs[0].name(), same_shard);
        each_once = each_once && run.description.shard.number == given.size();
        given.push_back(run.name() + " (" + std::to_string(run.description.shard.number + 1) + ")");
    }
    if (!each_once)
        throw InputError("expected each of the shards 1 to " + std::to_string(of) + " once, got " + join(given));
}

/// Throws InputError unless the shards have been saved at the same point of the run, with the same direct light.
void require_same_stage(const std::vector<SavedRun>& runs)
{
    for (const SavedRun& run : runs) {
        if (run.parts != runs[0].parts)
            throw InputError(run.name() + " is not as far as " + runs[0].name() +
                             "; expected finished shards: --resume continues one");
        if (!run.arrays->has_same(*runs[0].arrays, "run/incident"))
            throw InputError(run.name() + " has other direct light than " + runs[0].name() +
                             "; expected shards by the same version of multipath");
    }
}

/// Writes the average of shards that are independent runs.
void average(std::vector<SavedRun>& runs, const Scene& scene, std::uint64_t lines, Archive& sum)
{
    RunRecord record;
    std::vector<Solution> parts;
    for (SavedRun& run : runs) {
        const Archive::Inner inner(*run.arrays, RunRecord::part);
        RunRecord one;
        one.visit(*run.arrays, scene.patch_count());
        if (one.goal != 0 || one.pieces == 0)
            throw InputError(run.name() + ": this shard is not finished; expected --resume first");
        parts.push_back(std::move(one.solution));
    }
    record.pieces = 1;
    record.lines = lines;
    record.solution = combined(scene, parts);
    const Archive::Inner inner(sum, RunRecord::part);
    record.visit(sum, scene.patch_count());
}

/// The bytes of the state that a single run would have at this point.
std::string merged(std::vector<SavedRun>& runs, const SolveJob& job, const Scene& scene)
{
    std::string bytes;
    StateWriter sum([&](std::string_view more) { bytes += more; });
    SavedRun whole;
    whole.description = runs[0].description;
    whole.description.shard = {};
    whole.description.visit(sum);
    if (job.options.method->shards == Shards::added) {
        require_same_stage(runs);
        const auto shards = mapped(runs, [](const SavedRun& run) -> Archive* { return run.arrays.get(); });
        add_up_shards(shards, runs[0].parts, scene.patch_count(), job.options.threads, sum);
    } else {
        average(runs, scene, job.options.lines, sum);
    }
    runs[0].arrays->copy_rest(sum);
    sum.finish();
    return bytes;
}

int run_merge(const CommandLine& line)
{
    std::vector<SavedRun> runs = mapped(line.operands(), [](const std::string& path) { return read_saved_run(path); });
    if (runs.size() == 1 && runs[0].description.shard.of == 1)
        throw InputError(runs[0].name() +
                         ": the state of a whole run, not of a shard; 'multipath render' makes outputs from it");
    require_all_shards(runs);
    SavedJob wanted = open_saved_job(line, runs[0].description, runs[0].description.scene.file->path);
    SavedRun sum =
        read_saved_run(std::make_unique<StateReader>("the sum of the shards", merged(runs, wanted.job, wanted.scene)));
    const std::vector<std::string> paths = line.all("output");
    const auto is_state = [](const std::string& path) { return kind_of(path) == FormatKind::state; };
    if (!paths.empty() && std::all_of(paths.begin(), paths.end(), is_state)) {
        for (PlannedOutput& output : wanted.outputs)
            output.file.write(sum.arrays->bytes());
        commit(wanted.outputs);
        return 0;
    }
    runs.clear();
    StateKeeper keeper({}, true, sum.description);
    keeper.resume(std::move(sum));
    return carry_out(wanted.job, wanted.scene, wanted.outputs, keeper, {});
}

} // namespace

Command merge_command()
{
    return {{"merge",
             "add up the shards of one run (solve --shard)",
             {"STATE...", 1, any_number},
             {solution_output_group(), picture_option_group(), {"Computation", {threads_option()}}},
             "Shards of the method 'reuse' give the same bytes as a single run. Their first round counts lines; for a "
             "second round in shards, write the sum as a state and start from it (--from-state), or let 'merge' do all "
             "that is left. Shards of other methods are averaged by their lines.\n\n"
             "  multipath solve room.obj --shard 1/2 --state 1.state     and the same with 2/2\n"
             "  multipath merge 1.state 2.state -o room.png -o room.csv\n"},
            run_merge};
}

} // namespace multipath
