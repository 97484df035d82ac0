#include "cli/files/planned_outputs.h"
#include "cli/files/standard_streams.h"
#include "cli/options/number_text.h"
#include "cli/options/usage_error.h"
#include "cli/provenance.h"
#include "commands/commands.h"
#include "commands/explain/story_drawing.h"
#include "commands/explain/story_text.h"
#include "commands/options/method_options.h"
#include "commands/options/scene_options.h"
#include "transport/lines/global_lines.h"

#include <algorithm>
#include <cstdio>

namespace multipath {

namespace {

constexpr std::uint64_t most_lines_told = 1000;

CommandTable explain_table()
{
    return {
        "explain",
        "what single lines of a run do, one by one, in words and as a drawing",
        {{"SCENE.obj", false, false, {".obj"}}},
        {{"Story",
          {{"lines", 'n', "K", "3", "How many lines to tell, at most 1000; particles with the stage local."},
           {"first", 0, "N", "1",
            "Number of the first line told, counted from 1 in its stage. Those before it are followed too."},
           {"stage", 0, "STAGE", "",
            "Which lines: first-shot, rays from the sources; extended:PASS, rays of a pass of the extended first shot, "
            "counted from 1; global, lines through the scene; local, particles. Without it, local for --method local "
            "and global for the others."},
           {"output", 'o', "FILE", "",
            "Also draw the lines in the scene, from above and from the side; the extension is .svg. '-' writes the "
            "drawing to standard output instead of the text.",
            true},
           {"up", 0, "X,Y,Z", "0,1,0", "Which way is up in the drawing."}}},
         method_option_group({"of", 0, "N", "2^20", "Total number of lines of the run to which the told ones belong."},
                             false),
         scene_option_group()},
        "  multipath explain scenes/5cubes.obj --lines 3 -o lines.svg\n"
        "  multipath explain scenes/4chairs-up.obj --method extended --stage extended:2\n"
        "  multipath explain scenes/5cubes.obj --method local --of 10000\n"};
}

enum class StageKind { shot, global, local };

/// Which stage of the run is told.
struct Stage
{
    StageKind kind;
    std::size_t pass = 0; ///< of a shot, from 0
};

[[noreturn]] void refuse_stage(const std::string& stage, const std::string& method, const char* expected)
{
    throw UsageError("--stage: --method " + method + " has no stage " + stage + "; expected " + expected);
}

Stage read_stage(const CommandLine& line)
{
    const std::string method = line.text("method");
    const bool local = method == "local";
    const bool shoots = !local && method != "global";
    const std::string text = line.has("stage") ? line.text("stage") : local ? "local" : "global";
    const std::string extended = "extended:";
    const bool pass_named = text.compare(0, extended.size(), extended) == 0;
    if (text != "local" && text != "global" && text != "first-shot" && !pass_named)
        throw UsageError("--stage: expected first-shot, extended:PASS, global or local, got " + quoted_argument(text));
    if (local != (text == "local"))
        refuse_stage(text, method, local ? "local" : shoots ? "first-shot or global" : "global");
    if (local || text == "global")
        return {local ? StageKind::local : StageKind::global};
    if (!shoots)
        refuse_stage(text, method, "global, or --method first-shot or extended");
    if (!pass_named)
        return {StageKind::shot};
    if (method != "extended")
        refuse_stage(text, method, "first-shot, or --method extended");
    return {StageKind::shot, static_cast<std::size_t>(read_count("--stage", text.substr(extended.size()), 1)) - 1};
}

ToldRange read_told_range(const CommandLine& line)
{
    return {read_count("--first", line.text("first"), 1, std::uint64_t{1} << 48) - 1,
            read_count("--lines", line.text("lines"), 1, most_lines_told)};
}

/// Text and drawing of one story.
struct Telling
{
    std::string text;
    std::string title;
    std::vector<DrawnLine> lines;
};

Telling tell(const ToldRun& run, const Stage& stage, const ToldRange& range)
{
    if (stage.kind == StageKind::global) {
        const GlobalStory story = tell_global_pass(run.scene, run.options, range);
        return {story_text(run, story), "Lines of the global pass", drawn_lines(story)};
    }
    if (stage.kind == StageKind::local) {
        const ParticleStory story = tell_particles(run.scene, run.options, range);
        return {story_text(run, story), "Particles of local Monte Carlo", drawn_lines(run.scene, story)};
    }
    const ShotStory story = tell_shot_pass(run.scene, run.options, stage.pass, range);
    return {story_text(run, story), "Rays of pass " + std::to_string(stage.pass + 1) + " of the first shot",
            drawn_lines(run.scene, story)};
}

LineDrawing drawing_of(const ToldRun& run, const Stage& stage, const std::string& title)
{
    LineDrawing drawing;
    drawing.title = title;
    drawing.subtitle = run.scene.path() + ", --method " + run.method + ", sequence " + run.sequence;
    if (stage.kind == StageKind::global && chords_of(run.options) == Chords::box)
        drawing.box = run.scene.bounds();
    else if (stage.kind == StageKind::global)
        drawing.sphere = DrawnSphere{run.scene.bounds().centre(), 0.5 * run.scene.bounds().diagonal()};
    return drawing;
}

int run_explain(const CommandLine& line)
{
    require_options_with_effect(line);
    const Stage stage = read_stage(line);
    const ToldRange range = read_told_range(line);
    const Vec3 up = read_direction("--up", line.text("up"));
    const SolveOptions options = read_solve_options(line, "of");
    const std::string sequence = checked_sequence_name(options);
    const std::vector<std::string> paths = line.all("output");
    std::vector<PlannedOutput> outputs = open_outputs(paths, {scene_path(line)}, {".svg"});

    const Scene scene = read_scene(line);
    require_no_input(outputs, scene.file().material_files);
    for (const std::string& warning : scene.file().warnings)
        print_note(warning + "\n");
    const ToldRun run{scene, options, line.text("method"), sequence};
    const Telling telling = tell(run, stage, range);
    LineDrawing drawing = drawing_of(run, stage, telling.title);
    drawing.up = up;
    drawing.comments = provenance(explain_table(), line, scene);
    for (PlannedOutput& output : outputs)
        output.file.write(draw_lines(scene, telling.lines, drawing));
    commit(outputs);
    if (std::find(paths.begin(), paths.end(), "-") == paths.end())
        print(telling.text);
    return 0;
}

} // namespace

Command explain_command()
{
    return {explain_table(), run_explain};
}

} // namespace multipath
