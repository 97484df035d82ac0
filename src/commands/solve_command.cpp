#include "cli/progress.h"
#include "cli/provenance.h"
#include "cli/usage_error.h"
#include "commands/accuracy.h"
#include "commands/commands.h"
#include "commands/method_options.h"
#include "commands/picture_options.h"
#include "commands/scene_options.h"
#include "commands/solution_outputs.h"
#include "commands/solution_page.h"
#include "commands/solve_summary.h"
#include "radiosity/solve.h"
#include "sampling/sequence.h"
#include "scene/input_error.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>

namespace multipath {

namespace {

CommandTable solve_table()
{
    return {"solve",
            "radiosity of every patch of a scene, as pictures, meshes and tables",
            {{"SCENE.obj"}},
            {{"Output",
              {{"output", 'o', "FILE", "",
                "Where to write; by extension .ppm, .png, .pfm (pictures), .ply, .glb, .obj (meshes whose vertices "
                "have the light as colours), .csv (one row per patch) or .html (a page to walk through the room in a "
                "browser). '-' writes a PPM to standard output. Without it, SCENE.ppm and SCENE.png are written here.",
                true},
               {"json", 0, "", "", "Print a machine-readable summary on standard output."},
               {"quiet", 'q', "", "", "Print nothing on stderr but errors."},
               {"verbose", 'v', "", "", "Also show where the power is after every stage."},
               {"progress", 0, "WHEN", "auto", "Show progress on stderr.", false, {"auto", "always", "never"}}}},
             method_option_group(
                 {"lines", 'n', "N", "2^20",
                  "Total number of lines, local and global. Global lines that miss the scene's bounding box are free."},
                 true),
             accuracy_option_group(),
             scene_option_group(),
             picture_option_group()},
            "Numbers may be written 1000000, 1e6, 1M or 2^20.\n"
            "\n"
            "  multipath solve room.obj\n"
            "  multipath solve room.obj --lines 2^22 --sequence halton:2,7,3,5 -o room.png -o room.csv\n"
            "  multipath solve room.obj -o room.glb -o room.ply\n"
            "  multipath solve room.obj -o room.html\n"};
}

/// SCENE.ppm and SCENE.png in the working directory.
std::vector<std::string> default_outputs(const std::string& scene_path)
{
    std::string name = scene_path.substr(scene_path.find_last_of('/') + 1);
    const std::size_t dot = name.find_last_of('.');
    if (dot != std::string::npos && dot > 0)
        name.resize(dot);
    return {name + ".ppm", name + ".png"};
}

void print_what_was_read(const SceneFile& file)
{
    for (const std::string& warning : file.warnings)
        std::fprintf(stderr, "%s\n", warning.c_str());
    std::fprintf(stderr, "%s: %s\n", file.path.c_str(), file.counts.c_str());
}

void warn_of_line_count(const SolveOptions& options)
{
    const bool power_of_two = (options.lines & (options.lines - 1)) == 0;
    if (prefers_powers_of_two(options.sequence) && !power_of_two)
        std::fprintf(
            stderr, "note: Sobol's points are spread best when their number is a power of two, such as --lines 2^20\n");
}

/// A black picture is no result.
void require_light(const Scene& scene, const Solution& solution)
{
    if (!(mean(solution.balance.absorbed) > 0.0))
        throw InputError(
            scene.path() +
            ": no light reaches any surface: the emitters face away from everything; 'multipath check' tells more");
}

void require_error_to_show(const PictureOptions& pictures, const Accuracy& accuracy)
{
    if (pictures.shown == Shown::error && accuracy.replicates < 2)
        throw UsageError("--show: a single run does not tell its error; expected --replicates, such as 4, or "
                         "--tolerance with --show error");
}

void require_one_on_standard_output(const CommandLine& line)
{
    const std::vector<std::string> outputs = line.all("output");
    if (line.has("json") && std::find(outputs.begin(), outputs.end(), "-") != outputs.end())
        throw UsageError("--json and --output - would both write to standard output; expected a file for one of them");
}

int run_solve(const CommandLine& line)
{
    using Clock = std::chrono::steady_clock;
    const auto seconds_since = [](Clock::time_point start) {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    const Clock::time_point start = Clock::now();
    const bool quiet = line.has("quiet");
    require_options_with_effect(line);
    require_one_on_standard_output(line);
    const SolveOptions options = read_solve_options(line, "lines");
    const Accuracy accuracy = read_accuracy(line);
    const PictureOptions picture_options = read_picture_options(line, options.threads);
    require_error_to_show(picture_options, accuracy);
    const std::string sequence =
        accuracy.replicates > 1 ? randomised_name(checked_sequence_name(options)) : checked_sequence_name(options);
    const std::string scene_path = line.operands()[0];
    std::vector<PlannedOutput> outputs =
        open_outputs(line.has("output") ? line.all("output") : default_outputs(scene_path), {scene_path});

    const Scene scene = read_scene(line);
    require_outputs_beside(outputs, scene.file());
    if (!quiet) {
        print_what_was_read(scene.file());
        warn_of_line_count(options);
    }
    const Clock::time_point solve_start = Clock::now();
    double seconds_to_first_lines = 0.0;
    Solution solution;
    {
        Progress progress("solving", progress_style(line));
        solution = solve_accurately(scene, options, accuracy, [&](double done) {
            if (seconds_to_first_lines == 0.0)
                seconds_to_first_lines = seconds_since(start);
            progress.show(done);
        });
    }
    const double seconds_trace = seconds_since(solve_start);
    require_light(scene, solution);
    const std::vector<std::string> comments = provenance(solve_table(), line, scene);
    std::string page;
    if (has_page(outputs)) {
        Progress progress("solving with fewer lines, for the page", progress_style(line));
        page = solution_page({scene, options, line.text("method"), sequence}, solution, picture_options, comments,
                             [&](double done) { progress.show(done); });
    }
    write_outputs(outputs, scene, solution, picture_options, comments, page);

    const SolveSummary summary{scene,         options,
                               solution,      line.text("method"),
                               sequence,      seconds_since(start),
                               seconds_trace, seconds_to_first_lines};
    if (line.has("json"))
        std::fputs(summary_json(summary).document().c_str(), stdout);
    if (!quiet) {
        std::fputs(summary_text(summary).c_str(), stderr);
        if (line.has("verbose"))
            std::fputs(stages_text(solution).c_str(), stderr);
        for (const PlannedOutput& output : outputs)
            std::fprintf(stderr, "wrote      %s\n", output.file.name().c_str());
    }
    return 0;
}

} // namespace

Command solve_command()
{
    return {solve_table(), run_solve};
}

} // namespace multipath
