#include "commands/options/solve_table.h"

#include "cli/options/number_text.h"
#include "cli/options/usage_error.h"
#include "commands/options/method_options.h"
#include "commands/options/picture_options.h"
#include "commands/options/scene_options.h"
#include "commands/solve/accuracy.h"
#include "commands/solve/formats.h"
#include "scene/input_error.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <sys/stat.h>

namespace multipath {

namespace {

bool exists(const std::string& path)
{
    struct stat status = {};
    return stat(path.c_str(), &status) == 0;
}

/// "3/16" is the third of sixteen.
Share read_share_of_work(const std::string& text)
{
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos)
        throw UsageError("--shard: '" + text + "' is no part of a whole; expected I/N, such as 3/16");
    const std::uint64_t of = read_count("--shard", text.substr(slash + 1), 1, 1000000);
    return {read_count("--shard", text.substr(0, slash), 1, of) - 1, of};
}

OptionGroup state_option_group()
{
    return {"State",
            {{"state", 0, "FILE", "",
              "Keep the state of the run there, saved now and then and at the end: enough to go on after an "
              "interruption, to merge shards, or to make other pictures."},
             {"save-every", 0, "TIME", "60s", "How often to save the state."},
             {"resume", 0, "", "",
              "Go on from the --state file if there is one, with the same result as without the interruption; also to "
              "more --lines than it was made with."},
             {"from-state", 0, "FILE", "", "Go on from the state in this file, which stays as it is."},
             {"shard", 0, "I/N", "", "Do part I of N of the work, 1/N ... N/N, for 'multipath merge' to add up."}}};
}

} // namespace

OptionGroup solve_method_group()
{
    return method_option_group(
        {"lines", 'n', "N", "2^20",
         "Total number of lines, local and global. Global lines that miss the scene's bounding box are free."},
        true);
}

CommandTable solve_table()
{
    return {"solve",
            "radiosity of every patch of a scene, as pictures, meshes and tables",
            {{"SCENE.obj", false, false, {".obj"}}},
            {solution_output_group(), solve_method_group(), accuracy_option_group(), state_option_group(),
             scene_option_group(), picture_option_group()},
            "Numbers may be written 1000000, 1e6, 1M or 2^20.\n"
            "\n"
            "  multipath solve room.obj\n"
            "  multipath solve room.obj --lines 2^22 --sequence halton:2,7,3,5 -o room.png -o room.csv\n"
            "  multipath solve room.obj -o room.glb -o room.ply\n"
            "  multipath solve room.obj -o room.html\n"};
}

StateOptions read_state_options(const CommandLine& line)
{
    StateOptions options;
    options.state = line.text("state");
    // Thirty years are as good as never, and far from the end of what a clock counts.
    options.save_every = std::min(read_seconds("--save-every", line.text("save-every")), 1e9);
    if (line.has("shard"))
        options.share = read_share_of_work(line.text("shard"));
    if (line.has("state") && options.state.empty())
        throw UsageError("--state: the name is empty; expected a file");
    if (options.state.empty() && (line.has("resume") || line.has("save-every")))
        throw UsageError(std::string(line.has("resume") ? "--resume" : "--save-every") +
                         " has no effect without --state; expected --state FILE with it");
    const bool left = !options.state.empty() && exists(options.state);
    if (left && !line.has("resume"))
        throw InputError(options.state +
                         " exists; expected --resume with it to go on from there, or the name of a new file");
    options.from = left ? options.state : line.text("from-state");
    return options;
}

} // namespace multipath
