#include "base/errors.h"
#include "base/lists.h"
#include "base/text_format.h"
#include "cli/files/output_file.h"
#include "cli/files/standard_streams.h"
#include "cli/options/number_text.h"
#include "cli/provenance.h"
#include "commands/commands.h"
#include "commands/explain/trace_text.h"
#include "commands/options/method_options.h"
#include "commands/options/scene_options.h"
#include "explain/line_drawing.h"

#include <algorithm>

namespace multipath {

namespace {

constexpr std::uint64_t most_traced_lines = 1000;

/// The stage of the run whose lines are traced.
struct Stage
{
    const StageTracer* tracer;
    std::size_t pass = 0; ///< of a shot, from 0
};

Stage read_stage(const CommandLine& line)
{
    const std::vector<std::string_view> stages = traced_stages(method_named(line.text("method")));
    const std::string text = line.has("stage") ? line.text("stage") : std::string(stages.back());
    const std::string_view before_pass = later_pass.substr(0, later_pass.find(':') + 1);
    const bool pass_named = text.compare(0, before_pass.size(), before_pass) == 0;
    const std::string_view name = pass_named ? later_pass : std::string_view(text);
    if (!is_among(name, stages))
        throw UsageError("--stage: expected one of " + join(stages) + " with --method " + line.text("method") +
                         ", got " + quoted_argument(text));
    const auto* const stage =
        std::find_if(stage_tracers.begin(), stage_tracers.end(), [&](const StageTracer& s) { return s.stage == name; });
    if (!pass_named)
        return {stage};
    return {stage, static_cast<std::size_t>(read_count("--stage", text.substr(before_pass.size()), 1)) - 1};
}

int run_explain(const CommandLine& line)
{
    require_options_with_effect(line);
    const Stage stage = read_stage(line);
    const TracedRange range = {read_count("--first", line.text("first"), 1, std::uint64_t{1} << 48) - 1,
                               read_count("--lines", line.text("lines"), 1, most_traced_lines), stage.pass};
    const Vec3 up = read_direction("--up", line.text("up"));
    const SolveOptions options = read_solve_options(line, "of");
    const std::string sequence = checked_sequence_name(options);
    const std::vector<std::string> paths = line.all("output");
    std::vector<PlannedOutput> outputs = open_outputs(paths, {scene_path(line)}, {".svg"});

    const Scene scene = read_scene(line);
    require_no_input(outputs, input_files(scene.file()));
    for (const std::string& warning : scene.file().warnings)
        print_note(warning + "\n");
    const TracedRun run{scene, options, "--method " + line.text("method") + ", sequence " + sequence};
    const StageTrace trace = stage.tracer->trace(scene, options, range);
    for (PlannedOutput& output : outputs)
        output.file.write(draw_lines(run, trace, up, provenance(line, scene)));
    commit(outputs);
    if (!is_among("-", paths))
        print(trace_text(run, trace));
    return 0;
}

} // namespace

Command explain_command()
{
    return {
        {"explain",
         "explain single lines of a run, one by one, in words and as a drawing",
         {"SCENE.obj", 1, 1},
         {{"Lines",
           {{"lines", 'n', "K", "3",
             "Number of lines to explain, at most 1000; of particles or walks in the stages local and gathering."},
            {"first", 0, "N", "1", "First line to explain, counted from 1 in its stage."},
            {"stage", 0, "STAGE", "",
             "Stage of the lines, by default the last of the method: first-shot, rays from the sources; "
             "extended:PASS, rays of a pass counted from 1; global; bundle, lines of one direction; local, particles; "
             "gathering, walks of the first round; iteration, rays of the first one of jacobi."},
            {"output", 'o', "FILE", "",
             "Also draw the lines in the scene as .svg; '-' writes the drawing to standard output, without the text.",
             true},
            {"up", 0, "X,Y,Z", "0,1,0", "Upward direction of the drawing."}}},
          method_option_group({"of", 0, "N", "2^20", "Total number of lines of the run whose lines are explained."},
                              false),
          scene_option_group()},
         "  multipath explain scenes/4chairs-up.obj --method extended --stage extended:2 -o lines.svg\n"},
        run_explain};
}

} // namespace multipath
