#include "base/errors.h"
#include "cli/files/output_file.h"
#include "cli/files/standard_streams.h"
#include "cli/options/choices.h"
#include "cli/options/number_text.h"
#include "cli/provenance.h"
#include "commands/commands.h"
#include "commands/explain/trace_drawing.h"
#include "commands/explain/trace_text.h"
#include "commands/options/method_options.h"
#include "commands/options/scene_options.h"
#include "transport/lines/global_lines.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace multipath {

namespace {

constexpr std::uint64_t most_traced_lines = 1000;

CommandTable explain_table()
{
    return {"explain",
            "explain single lines of a run, one by one, in words and as a drawing",
            {{"SCENE.obj", false, false, {".obj"}}},
            {{"Lines",
              {{"lines", 'n', "K", "3",
                "Number of lines to explain, at most 1000; of particles or walks in the stages local and gathering."},
               {"first", 0, "N", "1",
                "First line to explain, counted from 1 in its stage. The lines before it are traced too."},
               {"stage", 0, "STAGE", "",
                "Stage of the lines: first-shot, rays from the sources; extended:PASS, rays of a pass of the extended "
                "first shot, counted from 1; global, lines through the scene; bundle, parallel lines of one direction; "
                "local, particles; gathering, walks of the first round; iteration, rays of the first one of jacobi. By "
                "default the last stage of the method."},
               {"output", 'o', "FILE", "",
                "Also draw the lines in the scene, from above and from the side, as .svg. '-' writes the drawing to "
                "standard output instead of the text.",
                true},
               {"up", 0, "X,Y,Z", "0,1,0", "Upward direction of the drawing."}}},
             method_option_group({"of", 0, "N", "2^20", "Total number of lines of the run whose lines are explained."},
                                 false),
             scene_option_group()},
            "  multipath explain scenes/5cubes.obj --lines 3 -o lines.svg\n"
            "  multipath explain scenes/4chairs-up.obj --method extended --stage extended:2\n"
            "  multipath explain scenes/5cubes.obj --method local --of 10000\n"};
}

/// Text and drawn lines of one trace.
struct Explanation
{
    std::string text;
    std::string title;
    std::vector<DrawnLine> lines;
    bool from_outside = false; ///< the drawing shows the sphere or box from which the lines start
};

Explanation explain_shot(const TracedRun& run, std::size_t pass, const TracedRange& range)
{
    const ShotTrace trace = trace_shot_pass(run.scene, run.options, pass, range);
    return {trace_text(run, trace), "Rays of pass " + std::to_string(pass + 1) + " of the first shot",
            drawn_lines(run.scene, trace)};
}

Explanation explain_global(const TracedRun& run, std::size_t, const TracedRange& range)
{
    const GlobalTrace trace = trace_global_pass(run.scene, run.options, range);
    return {trace_text(run, trace), "Lines of the global pass", drawn_lines(trace.lines), true};
}

Explanation explain_bundle(const TracedRun& run, std::size_t, const TracedRange& range)
{
    const BundleTrace trace = trace_bundle(run.scene, run.options, range);
    return {trace_text(run, trace), "Lines of one direction of transillumination", drawn_lines(trace.lines)};
}

Explanation explain_particles(const TracedRun& run, std::size_t, const TracedRange& range)
{
    const ParticleTrace trace = trace_particles(run.scene, run.options, range);
    return {trace_text(run, trace), "Particles of local Monte Carlo", drawn_lines(run.scene, trace)};
}

Explanation explain_walks(const TracedRun& run, std::size_t, const TracedRange& range)
{
    const WalkTrace trace = trace_walks(run.scene, run.options, range);
    return {trace_text(run, trace), "Gathering random walks", drawn_lines(run.scene, trace)};
}

Explanation explain_iteration(const TracedRun& run, std::size_t, const TracedRange& range)
{
    const JacobiTrace trace = trace_iteration(run.scene, run.options, range);
    return {trace_text(run, trace), "Rays of a stochastic Jacobi iteration", drawn_lines(run.scene, trace)};
}

struct NamedStage
{
    std::string_view name; ///< see MethodInfo::traced
    Explanation (*explain)(const TracedRun& run, std::size_t pass, const TracedRange& range);
};

constexpr std::string_view later_pass = "extended:PASS";
constexpr std::array<NamedStage, 7> known_stages = {{{"first-shot", explain_shot},
                                                     {later_pass, explain_shot},
                                                     {"global", explain_global},
                                                     {"bundle", explain_bundle},
                                                     {"local", explain_particles},
                                                     {"gathering", explain_walks},
                                                     {"iteration", explain_iteration}}};

/// The stage of the run whose lines are traced.
struct Stage
{
    const NamedStage* kind;
    std::size_t pass = 0; ///< of a shot, from 0
};

/// "a, b or c".
std::string alternatives(const std::vector<std::string_view>& names)
{
    std::string text;
    for (std::size_t k = 0; k < names.size(); ++k)
        text += (k == 0 ? "" : k + 1 < names.size() ? ", " : " or ") + std::string(names[k]);
    return text;
}

bool has_stage(Method method, std::string_view name)
{
    const std::vector<std::string_view> stages = traced_stages(method);
    return std::find(stages.begin(), stages.end(), name) != stages.end();
}

/// "first-shot or global, or --method extended": the stages of the method, and the methods with the stage.
std::string expected_stages(Method method, std::string_view name)
{
    std::string text = alternatives(traced_stages(method));
    const char* before = ", or --method ";
    for (const Method other : all_methods())
        if (has_stage(other, name)) {
            text += before + std::string(other->name);
            before = " or ";
        }
    return text;
}

Stage read_stage(const CommandLine& line)
{
    const Method method = method_named(line.text("method"));
    const std::string text = line.has("stage") ? line.text("stage") : std::string(traced_stages(method).back());
    const std::string_view before_pass = later_pass.substr(0, later_pass.find(':') + 1);
    const bool pass_named = text.compare(0, before_pass.size(), before_pass) == 0;
    const std::string_view name = pass_named ? later_pass : std::string_view(text);
    const auto* const stage =
        std::find_if(known_stages.begin(), known_stages.end(), [&](const NamedStage& s) { return s.name == name; });
    if (stage == known_stages.end()) {
        std::vector<std::string_view> names;
        for (const NamedStage& known : known_stages)
            names.push_back(known.name);
        throw UsageError("--stage: expected " + alternatives(names) + ", got " + quoted_argument(text));
    }
    if (!has_stage(method, name))
        throw UsageError("--stage: --method " + line.text("method") + " has no stage " + text + "; expected " +
                         expected_stages(method, name));
    if (!pass_named)
        return {stage};
    return {stage, static_cast<std::size_t>(read_count("--stage", text.substr(before_pass.size()), 1)) - 1};
}

TracedRange read_traced_range(const CommandLine& line)
{
    return {read_count("--first", line.text("first"), 1, std::uint64_t{1} << 48) - 1,
            read_count("--lines", line.text("lines"), 1, most_traced_lines)};
}

LineDrawing drawing_of(const TracedRun& run, const Explanation& explanation)
{
    LineDrawing drawing;
    drawing.title = explanation.title;
    drawing.subtitle = run.scene.path() + ", --method " + run.method + ", sequence " + run.sequence;
    if (explanation.from_outside && chords_of(run.options) == Chords::box)
        drawing.box = run.scene.bounds();
    else if (explanation.from_outside)
        drawing.sphere = DrawnSphere{run.scene.bounds().centre(), 0.5 * run.scene.bounds().diagonal()};
    return drawing;
}

int run_explain(const CommandLine& line)
{
    require_options_with_effect(line);
    const Stage stage = read_stage(line);
    const TracedRange range = read_traced_range(line);
    const Vec3 up = read_direction("--up", line.text("up"));
    const SolveOptions options = read_solve_options(line, "of");
    const std::string sequence = checked_sequence_name(options);
    const std::vector<std::string> paths = line.all("output");
    std::vector<PlannedOutput> outputs = open_outputs(paths, {scene_path(line)}, {".svg"});

    const Scene scene = read_scene(line);
    require_no_input(outputs, input_files(scene.file()));
    for (const std::string& warning : scene.file().warnings)
        print_note(warning + "\n");
    const TracedRun run{scene, options, line.text("method"), sequence};
    const Explanation explanation = stage.kind->explain(run, stage.pass, range);
    LineDrawing drawing = drawing_of(run, explanation);
    drawing.up = up;
    drawing.comments = provenance(explain_table(), line, scene);
    for (PlannedOutput& output : outputs)
        output.file.write(draw_lines(scene, explanation.lines, drawing));
    commit(outputs);
    if (std::find(paths.begin(), paths.end(), "-") == paths.end())
        print(explanation.text);
    return 0;
}

} // namespace

Command explain_command()
{
    return {explain_table(), run_explain};
}

} // namespace multipath
