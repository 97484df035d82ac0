#include "commands/solve/solve_job.h"

#include "check/scene_check.h"
#include "check/scene_report.h"
#include "cli/files/interrupt.h"
#include "cli/files/standard_streams.h"
#include "cli/options/usage_error.h"
#include "cli/progress.h"
#include "cli/provenance.h"
#include "commands/options/memory_limit.h"
#include "commands/options/method_options.h"
#include "commands/options/solve_table.h"
#include "commands/solve/formats.h"
#include "commands/solve/solution_page.h"
#include "commands/solve/solve_summary.h"
#include "radiosity/line_budget.h"
#include "sampling/sequence.h"
#include "scene/input_error.h"
#include "scene/text/text_format.h"

#include <algorithm>

namespace multipath {

namespace {

/// True if the scene consists of lamps alone: they look right whether or not they light each other.
bool everything_shines(const Scene& scene)
{
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (!(mean(scene.emittance(i)) > 0.0))
            return false;
    return true;
}

/// A black picture is no result.
void require_light(const Scene& scene, const Solution& solution, int threads)
{
    const PowerBalance& balance = solution.balance;
    if (!(mean(balance.absorbed + balance.escaped + balance.behind) > 0.0))
        throw SettingsError(
            scene.path() + ": none of " + grouped(solution.all_lines) + " lines left a source; " +
            (solution.all_lines < scene.patch_count() ? "expected more with --lines" : "'multipath check' tells more"));
    const double rounding = 1e-9 * mean(balance.emitted); // of what line reuse finds by its balance
    if (mean(balance.absorbed) > rounding || everything_shines(scene))
        return;
    constexpr std::uint64_t lines_to_look = 1 << 16;
    const bool inside_out = is_inside_out(scene, survey_lines(scene, scene_hull(scene), lines_to_look, threads));
    const std::string dark = scene.path() + ": no light reaches any surface: ";
    if (mean(balance.behind) > rounding)
        throw InputError(dark + "it meets all of them from behind; " +
                         (inside_out ? "--flip turns all faces over, " : "") + "--two-sided gives them backs");
    throw InputError(dark + (inside_out ? "the scene is inside out; --flip turns all its faces over"
                                        : "the emitters face away from everything; 'multipath check' tells more"));
}

void require_error_to_show(const PictureOptions& pictures, const Accuracy& accuracy)
{
    if (pictures.shown.needs_replicates && accuracy.replicates < 2)
        throw UsageError("--show: a single run does not tell its error; expected --replicates, such as 4, or "
                         "--tolerance with --show " +
                         std::string(pictures.shown.name));
}

/// Refuses pictures that the memory cannot hold. Without named outputs there are pictures, except of a shard.
void require_memory_for_pictures(const CommandLine& line, const RenderOptions& render)
{
    const std::vector<std::string> paths = line.all("output");
    const auto is_picture = [](const std::string& path) { return kind_of(path) == FormatKind::picture; };
    if (paths.empty() ? !line.has("shard") : std::any_of(paths.begin(), paths.end(), is_picture))
        require_memory_for_picture(line, render.width, render.height, render.shading == Shading::gather);
}

double seconds_since(SolveJob::Clock::time_point start)
{
    return std::chrono::duration<double>(SolveJob::Clock::now() - start).count();
}

void tell_of_interruption(const SolveJob& job, const Solution& solution, const StateKeeper& keeper)
{
    print_note(format("interrupted after %s of %s lines%s\n", grouped(solution.all_lines).c_str(),
                      grouped(job.options.lines).c_str(),
                      keeper.path().empty() ? "; --state FILE would let it go on from there"
                                            : ("; --resume goes on from " + keeper.path()).c_str()));
}

int tell_of_share(const SolveJob& job, const StateKeeper& keeper)
{
    if (!job.quiet)
        print_note(format("%s; 'multipath merge' adds the shares up\n",
                          keeper.handed_in() ? "this share is done" : "interrupted; --resume goes on with this share"));
    return keeper.handed_in() ? 0 : exit_interrupted;
}

} // namespace

SolveJob read_solve_job(const CommandLine& line)
{
    require_options_with_effect(line);
    SolveJob job{line, read_solve_options(line, "lines"), read_accuracy(line), {}, "", line.has("quiet")};
    job.pictures = read_picture_options(line, job.options.threads);
    require_memory_for_pictures(line, job.pictures.render);
    require_error_to_show(job.pictures, job.accuracy);
    const std::string name = checked_sequence_name(job.options);
    job.sequence = job.accuracy.replicates > 1 ? randomised_name(name) : name;
    return job;
}

void require_results_possible(const SolveJob& job, const Scene& scene, const std::vector<PlannedOutput>& outputs)
{
    require_view(scene, job.pictures);
    if (has_kind(outputs, FormatKind::page))
        require_memory_for_page(job.line, scene);
}

void write_results(const SolveJob& job, const Scene& scene, const Solution& solution,
                   std::vector<PlannedOutput>& outputs, const std::string& state)
{
    const std::vector<std::string> comments = provenance(solve_table(), job.line, scene);
    const PictureOptions pictures =
        has_view(outputs) ? with_camera(job.pictures, scene, solution.radiosity) : job.pictures;
    if (!job.quiet && has_view(outputs) && pictures.shown.is_room())
        print_note(black_picture_warning(scene, solution.radiosity, pictures));
    const auto page = [&] {
        Progress progress("solving with fewer lines, for the page", progress_style(job.line));
        return solution_page({scene, job.options, job.line.text("method"), job.sequence}, solution, pictures, comments,
                             [&](double done) { progress.show(done); });
    };
    SolvedScene solved(
        scene, solution, pictures, comments, [&] { return state; }, page);
    write_outputs(outputs, solved);
}

int carry_out(const SolveJob& job, const Scene& scene, std::vector<PlannedOutput>& outputs, StateKeeper& keeper,
              Share share)
{
    const SolveJob::Clock::time_point solve_start = SolveJob::Clock::now();
    double seconds_to_first_lines = 0.0;
    Solution solution;
    {
        Progress progress("solving", progress_style(job.line));
        const auto show = [&](double done) {
            if (seconds_to_first_lines == 0.0) {
                seconds_to_first_lines = seconds_since(job.start);
                watch_interrupts(); // from now on there are results as of then
            }
            progress.show(done);
        };
        solution = solve_accurately(scene, job.options, job.accuracy, show, &keeper, share);
    }
    const double seconds_trace = seconds_since(solve_start);
    if (keeper.stopped() && share.of > 1) {
        write_results(job, scene, solution, outputs, keeper.last_bytes());
        return tell_of_share(job, keeper);
    }
    if (share.of > 1 && job.options.method->shards == Shards::added)
        throw InputError("nothing is left to be shared; expected the same without --shard, which does the rest");
    if (keeper.stopped())
        tell_of_interruption(job, solution, keeper); // before what may be given up
    else
        require_light(scene, solution, job.options.threads);
    const SolveJob::Clock::time_point outputs_start = SolveJob::Clock::now();
    write_results(job, scene, solution, outputs, keeper.last_bytes());
    const double seconds_outputs = seconds_since(outputs_start);

    const SolveSummary summary{scene,
                               job.options,
                               solution,
                               job.line.text("method"),
                               job.sequence,
                               seconds_since(job.start),
                               seconds_trace,
                               seconds_outputs,
                               seconds_to_first_lines,
                               !keeper.stopped(),
                               !keeper.resumed()};
    if (job.line.has("json"))
        print(summary_json(summary).document());
    if (!job.quiet) {
        print_note(summary_text(summary));
        if (job.line.has("verbose"))
            print_note(stages_text(solution));
        for (const PlannedOutput& output : outputs)
            print_note(format("wrote      %s\n", output.file.name().c_str()));
    }
    return keeper.stopped() ? exit_interrupted : 0;
}

} // namespace multipath
