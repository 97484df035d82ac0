// The course of `solve` and `merge` after the scene has been read: solve (once, in replicates or in rounds), write the
// outputs, print the summary. A run that the user interrupts still writes its partial results. A shard (one part of a
// run that is split over several computers) writes only its state, or the results of its own lines.

#include "commands/solve/solve_job.h"

#include "base/errors.h"
#include "base/text_format.h"
#include "cli/files/interrupt.h"
#include "cli/files/standard_streams.h"
#include "cli/progress.h"
#include "commands/options/memory_limit.h"
#include "commands/options/method_options.h"
#include "commands/solve/formats.h"
#include "commands/solve/solve_summary.h"

#include <utility>

namespace multipath {

namespace {

/// True if some patch sends more light than it emits (white ones absorb nothing, however bright they are), or if all
/// emit: such a scene looks right even if no lamp lights another.
bool has_bright_surfaces(const Scene& scene, const Solution& solution)
{
    bool all_emit = true;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        if (mean(solution.radiosity[i] - scene.emittance(i)) > 1e-9 * mean(solution.radiosity[i]))
            return true;
        all_emit = all_emit && mean(scene.emittance(i)) > 0.0;
    }
    return all_emit;
}

/// Throws SettingsError or InputError, with the reason, if no light has reached any surface: a black picture is not a
/// result.
void require_light(const Scene& scene, const Solution& solution)
{
    const PowerBalance& balance = solution.balance;
    const double rounding = 1e-9 * mean(balance.emitted); // line reuse gets some powers as differences
    const bool has_left_source = mean(balance.absorbed + balance.escaped + balance.behind) > 0.0;
    if (has_left_source && (mean(balance.absorbed) > rounding || has_bright_surfaces(scene, solution)))
        return;
    if (solution.all_lines < scene.patch_count())
        throw SettingsError(scene.path() + ": " + grouped(solution.all_lines) +
                            " lines found no light on any surface; expected more with --lines");
    throw InputError(scene.path() + ": no light reaches any surface: " +
                     (mean(balance.behind) > rounding
                          ? "it meets all of them from behind; --two-sided gives them backs"
                          : "the emitters face away from everything; 'multipath check' tells why"));
}

void require_error_to_show(const PictureOptions& pictures, const Accuracy& accuracy)
{
    if (pictures.shown.needs_replicates && accuracy.replicates < 2)
        throw UsageError("--show: a single run cannot estimate its error; expected --replicates, such as 4, or "
                         "--tolerance with --show " +
                         std::string(pictures.shown.name));
}

double seconds_since(SolveJob::Clock::time_point start)
{
    return std::chrono::duration<double>(SolveJob::Clock::now() - start).count();
}

void report_interruption(const SolveJob& job, const Solution& solution, const StateKeeper& keeper)
{
    print_note(format("interrupted after %s of %s lines%s\n", grouped(solution.all_lines).c_str(),
                      grouped(job.options.lines).c_str(),
                      keeper.path().empty() ? "; with --state FILE it could be resumed"
                                            : ("; --resume continues from " + keeper.path()).c_str()));
}

} // namespace

SolveJob read_solve_job(const CommandLine& line)
{
    require_options_with_effect(line);
    SolveJob job{line, read_solve_options(line, "lines"), read_accuracy(line), {}, "", line.has("quiet")};
    job.pictures = read_picture_options(line, job.options.threads);
    require_error_to_show(job.pictures, job.accuracy);
    job.sequence = checked_sequence_name(job.options, "--sequence", job.accuracy.replicates > 1);
    return job;
}

void require_results_possible(const SolveJob& job, const Scene& scene, const std::vector<PlannedOutput>& outputs)
{
    require_view(scene, job.pictures);
    if (has_kind(outputs, FormatKind::page))
        require_memory_for_page(job.line, scene);
}

SavedJob open_saved_job(const CommandLine& line, const RunDescription& saved, const std::string& name)
{
    SolveJob job = read_solve_job(command_line_of(saved, line.words(all_options(line.table().groups))));
    const std::vector<std::string> inputs =
        concatenated({input_files(*saved.scene.file), line.operands(), line.all("camera")});
    std::vector<PlannedOutput> outputs = open_solution_outputs(
        job.line, line.has("output") ? line.all("output") : default_outputs(name), inputs, job.pictures);
    Scene scene = restored(saved.scene);
    require_results_possible(job, scene, outputs);
    return {std::move(job), std::move(scene), std::move(outputs)};
}

int carry_out(const SolveJob& job, const Scene& scene, std::vector<PlannedOutput>& outputs, StateKeeper& keeper,
              Shard shard)
{
    const SolveJob::Clock::time_point solve_start = SolveJob::Clock::now();
    double seconds_to_first_lines = 0.0;
    Solution solution;
    {
        Progress progress("solving", progress_style(job.line));
        const auto show = [&](double done) {
            if (seconds_to_first_lines == 0.0) {
                seconds_to_first_lines = job.seconds_since_start();
                watch_interrupts(); // from now on there are partial results
            }
            progress(done);
        };
        solution = solve_accurately(scene, job.options, job.accuracy, show, &keeper, shard);
    }
    end_at_interrupts();
    const double seconds_trace = seconds_since(solve_start);
    if (keeper.stopped() && shard.of > 1) {
        const std::string names = write_outputs(outputs, job, scene, solution, keeper.last_bytes());
        if (!job.quiet)
            print_note(
                format("%s; 'multipath merge' adds the shards up\n",
                       keeper.published() ? "this shard is done" : "interrupted; --resume continues this shard") +
                names);
        return keeper.published() ? exit_done : exit_interrupted;
    }
    if (shard.of > 1 && job.options.method->shards == Shards::added)
        throw InputError("no work is left for shards; expected the same command without --shard, which does the rest");
    if (keeper.stopped())
        report_interruption(job, solution, keeper); // before the outputs, which a second signal may end
    else
        require_light(scene, solution);
    const SolveJob::Clock::time_point outputs_start = SolveJob::Clock::now();
    const std::string names = write_outputs(outputs, job, scene, solution, keeper.last_bytes());
    const double seconds_outputs = seconds_since(outputs_start);

    const SolveSummary summary{job,
                               scene,
                               solution,
                               job.seconds_since_start(),
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
        print_note(names);
    }
    return keeper.stopped() ? exit_interrupted : 0;
}

} // namespace multipath
