#include "cli/interrupt.h"
#include "cli/number_text.h"
#include "cli/planned_outputs.h"
#include "cli/progress.h"
#include "cli/provenance.h"
#include "cli/standard_streams.h"
#include "cli/usage_error.h"
#include "commands/commands.h"
#include "commands/memory_limit.h"
#include "commands/method_options.h"
#include "commands/scene_options.h"
#include "commands/study_cache.h"
#include "commands/study_curves.h"
#include "study/convergence.h"
#include "study/convergence_plot.h"
#include "study/study_table.h"

#include <algorithm>

namespace multipath {

namespace {

CommandTable study_table()
{
    const OptionGroup settings = without_options(
        method_option_group({}, true), {"", "method", "sequence", "pairing", "line-order", "chords", "power-per-line"});
    return {"study",
            "error against number of lines, for methods and sequences, with fitted slopes",
            {{"SCENE.obj", false, false, {".obj"}}},
            {{"Output",
              {{"output", 'o', "FILE", "",
                "Where to write besides the table on standard output; by extension .csv (one row per point) or .svg (a "
                "plot).",
                true},
               {"against", 0, "WHAT", "lines", "What the plot has across.", false, {"lines", "seconds"}},
               {"cache", 0, "FOLDER", "",
                "Where to keep finished runs and the reference, so that the same study goes on where it was "
                "interrupted; a program from other sources begins anew. Without it, the first output's name with "
                ".cache for its extension; without an output, "
                "nothing is kept."},
               {"quiet", 'q', "", "", "Print nothing but errors on stderr, and no table when there is an output."},
               {"progress", 0, "WHEN", "auto", "Show progress on stderr.", false, {"auto", "always", "never"}}}},
             study_curve_options(),
             {"Points",
              {{"from", 0, "N", "2^14", "Lines of the first point; every further point has twice as many."},
               {"to", 0, "N", "2^20", "No point has more lines."},
               {"replicates", 0, "R", "4",
                "Runs of which each point is the mean: of other seeds, or of other stretches of a sequence that has no "
                "seed."},
               {"reference", 0, "FILE", "",
                "Measure the error against this table of patches, as solve writes it. Without it, one is computed "
                "with 16 times the lines of the last point, and its own error estimated."}}},
             {"Every run", settings.options},
             scene_option_group()},
            "The seconds are processor time of one thread; --threads runs go on at a time.\n"
            "\n"
            "  multipath study scenes/5cubes.obj --methods first-shot,reuse --sequences random,sobol -o study.svg\n"
            "  multipath study scenes/5cubes.obj --methods first-shot --sequences sobol,halton:2,7,3,5\n"};
}

std::vector<std::uint64_t> line_counts(const CommandLine& line)
{
    constexpr std::uint64_t longest_study = std::uint64_t{1} << 40; // months
    const std::uint64_t from = read_count("--from", line.text("from"), 1, longest_study);
    const std::uint64_t to = read_count("--to", line.text("to"), 1, longest_study);
    if (to < from)
        throw UsageError("--to: expected at least the lines of --from, got fewer");
    std::vector<std::uint64_t> counts;
    for (std::uint64_t lines = from; lines <= to; lines *= 2)
        counts.push_back(lines);
    return counts;
}

StudyPlan read_plan(const CommandLine& line)
{
    StudyPlan plan;
    plan.curves = read_curves(line);
    plan.line_counts = line_counts(line);
    plan.executions = static_cast<int>(read_count("--replicates", line.text("replicates"), 1, 10000));
    plan.seed = read_count("--seed", line.text("seed"));
    return plan;
}

std::string plot_title(const Scene& scene)
{
    return scene.path() + ", " + std::to_string(scene.patch_count()) + " patches";
}

int run_study_command(const CommandLine& line)
{
    const StudyPlan plan = read_plan(line);
    const int threads = thread_count(line);
    const std::vector<std::string> paths = line.all("output");
    std::vector<std::string> inputs = {scene_path(line)};
    if (line.has("reference"))
        inputs.push_back(line.text("reference"));
    std::vector<PlannedOutput> outputs = open_outputs(paths, inputs, {OutputFormat::csv, OutputFormat::svg});

    const Scene scene = read_scene(line, threads);
    require_no_input(outputs, scene.file().material_files);
    const std::vector<std::string> comments = provenance(study_table(), line, scene);
    const StudyCache cache(line, paths);
    always_end_at_interrupts(cache.path("") ? "the same command goes on from the runs that were finished" : "");
    const Reference reference = study_reference(line, scene, plan, cache);
    Study study;
    {
        const std::unique_ptr<Journal> journal = cache.journal(study_table(), line, scene, reference);
        Progress progress("study", progress_style(line));
        const bool reuses = std::any_of(plan.curves.begin(), plan.curves.end(),
                                        [](const CurvePlan& c) { return c.options.method == Method::reuse; });
        const int at_a_time = reuses ? reuse_runs_at_a_time(line, scene, threads) : threads;
        study = run_study(scene, reference, plan, *journal, at_a_time, [&](double done) { progress.show(done); });
    }
    const Abscissa against = line.text("against") == "seconds" ? Abscissa::seconds : Abscissa::lines;
    for (PlannedOutput& output : outputs)
        output.file.write(output.format == OutputFormat::csv
                              ? study_csv(study, comments)
                              : convergence_plot(study, against, plot_title(scene), comments));
    commit(outputs);
    if (!line.has("quiet") || paths.empty())
        print(plot_title(scene) + "\n" + study_text(study));
    return 0;
}

} // namespace

Command study_command()
{
    return {study_table(), run_study_command};
}

} // namespace multipath
