// The course of `solve` and `merge` after the scene has been read: solve (once, in replicates or in rounds), write the
// outputs, print the summary. A run that the user interrupts still writes its partial results. A shard (one part of a
// run that is split over several computers) writes only its state, or the results of its own lines. The summary warns
// of results that are wrong or noisy: too few lines, unshot or lost power, sequences that do not sample the sources
// uniformly.

#include "commands/solve/solve_job.h"

#include "base/elementary.h"
#include "base/errors.h"
#include "base/text_format.h"
#include "check/scene_check.h"
#include "check/scene_report.h"
#include "cli/files/interrupt.h"
#include "cli/files/standard_streams.h"
#include "cli/progress.h"
#include "cli/provenance.h"
#include "commands/commands.h"
#include "commands/options/memory_limit.h"
#include "commands/options/method_options.h"
#include "commands/solve/formats.h"
#include "commands/solve/solution_page.h"
#include "radiosity/paper/line_budget.h"
#include "radiosity/reuse/balanced_reuse.h"
#include "radiosity/run/replicates.h"
#include "radiosity/run/statistics.h"
#include "sampling/sequence.h"
#include "scene/scene_file.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace multipath {

namespace {

/// Area-weighted mean over all patches except those of the sky [W/m^2].
Rgb mean_radiosity(const SolveSummary& s)
{
    Rgb power;
    for (std::uint32_t i = 0; i < s.scene.patch_count(); ++i)
        if (!s.scene.is_sky(s.scene.surface_of(i)))
            power += s.scene.area(i) * s.solution.radiosity[i];
    return (1.0 / s.scene.own_area()) * power;
}

/// [1] Power that the unshot light could still add, relative to the power of the result: every reflection is assumed to
/// be by surfaces of the same reflectance, at most 1 - 1e-4, so that unshot power U adds U / (1 - rho).
double growth_by_unshot_light(const SolveSummary& s)
{
    double growth = 0.0; // [W]
    double power = 0.0;  // [W]
    for (std::uint32_t i = 0; i < s.scene.patch_count(); ++i) {
        const Rgb rho = s.scene.reflectance(i);
        const Rgb unshot = s.solution.unshot[i];
        for (double Rgb::*const channel : {&Rgb::r, &Rgb::g, &Rgb::b})
            growth += s.scene.area(i) / 3.0 * unshot.*channel / std::max(1.0 - rho.*channel, 1e-4);
        if (!s.scene.is_sky(s.scene.surface_of(i)))
            power += s.scene.area(i) * mean(s.solution.radiosity[i]);
    }
    return power > 0.0 ? growth / power : 0.0;
}

/// [1] Area-weighted mean without the sky.
double mean_reflectance(const Scene& scene)
{
    return mean(scene.average_reflectance()) * (scene.total_area() / scene.own_area());
}

double lines_per_second(const SolveSummary& s)
{
    const auto lines = static_cast<double>(s.solution.all_lines);
    return s.seconds_trace > 0.0 && s.all_at_once ? lines / s.seconds_trace : 0.0;
}

std::vector<double> channels(Rgb c)
{
    return {c.r, c.g, c.b};
}

} // namespace

std::optional<double> SolveSummary::error() const
{
    if (!accuracy.patch_error || !solution.relative_standard_error)
        return std::nullopt;
    return elementary::hypot(*accuracy.patch_error, *solution.relative_standard_error);
}

std::optional<double> SolveSummary::error_of_important() const
{
    if (!options.importance || solution.standard_error.empty())
        return std::nullopt;
    std::vector<double> weights = options.importance->weight;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        weights[i] *= scene.area(i);
    return std::sqrt(expected_relative_square(weights, solution.radiosity, solution.standard_error));
}

namespace {

/// A share in percent: "0.62 %", "98 %", "150 %".
std::string percent_text(double share)
{
    const double percent = 100.0 * share;
    return format(percent < 99.5 ? "%.2g %%" : "%.0f %%", percent);
}

std::string important_text(const SolveSummary& s)
{
    std::uint64_t patches = 0;
    for (const double weight : s.options.importance->weight)
        patches += weight > 0.0 ? 1 : 0;
    const std::optional<double> error = s.error_of_important();
    return format("important  %s patches%s\n", grouped(patches).c_str(),
                  error ? (": noise " + percent_text(*error) + " of their mean").c_str()
                        : "; --replicates estimates their error");
}

} // namespace

std::string summary_text(const SolveSummary& s)
{
    const PowerBalance& balance = s.solution.balance;
    const auto percent = [&](Rgb part) {
        const double share = 100.0 * mean(part) / mean(balance.emitted);
        return std::abs(share) < 5e-4 ? 0.0 : share; // avoids "-0.000"
    };
    const Rgb b = mean_radiosity(s);
    const std::string method(s.options.method->name);
    std::string text;
    text += format("scene      %s surfaces%s, %s patches, %.4g m^2, mean reflectance %.3f\n",
                   grouped(s.scene.own_surfaces()).c_str(), s.scene.file().sky_surfaces > 0 ? " and the sky" : "",
                   grouped(s.scene.patch_count()).c_str(), s.scene.own_area(), mean_reflectance(s.scene));
    text += format("method     %s, sequence %s: %s local + %s global lines\n", method.c_str(), s.sequence.c_str(),
                   grouped(s.solution.local_lines).c_str(), grouped(s.solution.global_lines).c_str());
    if (const std::optional<double> error = s.error())
        text += format("error      %s of the mean (patches %s, noise %s), by %d replicates%s\n",
                       percent_text(*error).c_str(), percent_text(*s.accuracy.patch_error).c_str(),
                       percent_text(*s.solution.relative_standard_error).c_str(), s.solution.replicates,
                       s.solution.all_lines > s.solution.local_lines + s.solution.global_lines
                           ? (" of the last round; " + grouped(s.solution.all_lines) + " lines in all rounds").c_str()
                           : "");
    if (s.options.importance)
        text += important_text(s);
    if (s.accuracy.tolerance && s.error() > *s.accuracy.tolerance)
        text += format("warning    that is above the tolerance of %.3g %%: %s\n", 100.0 * *s.accuracy.tolerance,
                       *s.accuracy.patch_error > std::sqrt(0.5) * *s.accuracy.tolerance
                           ? "there are too few patches; up to a million are chosen if no option fixes them"
                           : "the limit of lines or time was reached");
    const std::uint64_t lines = s.solution.local_lines + s.solution.global_lines;
    if (s.solution.relative_standard_error &&
        lines < lines_for_error_estimate(s.scene, s.options.method, s.solution.replicates))
        text += format("warning    with fewer than %d lines per patch in each replicate the error may be several times "
                       "larger than this; more lines or fewer replicates help\n",
                       static_cast<int>(s.options.method->lines_per_patch(s.scene)));
    const LightUnits units = light_units(s.scene.file());
    text += format("radiosity  mean %.6g  (%.4g, %.4g, %.4g) %s\n", mean(b), b.r, b.g, b.b, units.per_area);
    text += format("power      emitted %.6g %s: %.2f %% absorbed, %.3f %% unshot, %.2f %% escaped, %.2f %% lost behind "
                   "surfaces; balance to %.0e\n",
                   mean(balance.emitted), units.power, percent(balance.absorbed), percent(balance.unshot),
                   percent(balance.escaped), percent(balance.behind), balance.relative_error());
    if (s.options.method == Method::reuse && s.complete && s.solution.global_lines == 0 &&
        lines < min_balanced_rays(s.scene))
        text +=
            format("warning    too few lines per patch for line reuse: particles carried the light, with more noise; "
                   "%s lines are enough for reuse\n",
                   grouped(min_balanced_rays(s.scene)).c_str());
    else if (constexpr std::uint64_t few = 16; lines < few * s.scene.patch_count())
        text +=
            format("warning    only %.2g lines per patch, and neighbours differ by noise; --lines %s gives each patch "
                   "24 or more\n",
                   static_cast<double>(lines) / s.scene.patch_count(), usual_lines(s.scene).c_str());
    if (s.solution.by_particles)
        text +=
            format("warning    method %s finds no sound solution with these lines: particles carried the light, with "
                   "more noise; more lines help\n",
                   std::string(s.options.method->name).c_str());
    const double surplus = mean(balance.emitted) - mean(balance.source);
    if (balance.emitted_error > 0.0 && std::abs(surplus) > 4.0 * balance.emitted_error)
        text +=
            format("warning    the lines sent %.4g %s, but the sources emit %.4g, and noise explains a difference of "
                   "only %.2g: these lines are not uniform, and the result is wrong to the same degree\n",
                   mean(balance.emitted), units.power, mean(balance.source), balance.emitted_error);
    if (percent(balance.unshot) > 5.0)
        text += format("warning    %s of the power is not distributed yet, which makes the result too dark; more "
                       "lines help, or larger patches\n",
                       percent_text(0.01 * percent(balance.unshot)).c_str());
    else if (const double more = growth_by_unshot_light(s); more > 0.1)
        text += format("warning    the %s of the power that is not distributed yet is on surfaces that reflect "
                       "nearly all of it, and may make the result brighter by %s; more lines help, or "
                       "--method reuse\n",
                       percent_text(0.01 * percent(balance.unshot)).c_str(), percent_text(more).c_str());
    if (percent(balance.behind) > 0.01 && !s.scene.file().sky_surfaces) // the sky also shines on outer sides
        text += format(
            "warning    %.3g %% of the power met surfaces from behind and is lost, which makes the result too dark; "
            "'multipath check' names them, --two-sided gives them backs\n",
            percent(balance.behind));
    if (!s.all_at_once)
        return text + format("time       %.2f s, of this part of the run\n", s.seconds);
    text +=
        format("time       %.2f s, %.2f s of it tracing: %.2f million lines/s on %d thread%s; %.2f s for the outputs\n",
               s.seconds, s.seconds_trace, 1e-6 * lines_per_second(s), s.options.threads,
               s.options.threads == 1 ? "" : "s", s.seconds_outputs);
    return text;
}

std::string stages_text(const Solution& solution)
{
    const auto row = [](const std::string& stage, std::uint64_t lines, const PowerBalance& b) {
        return format("  %-12s %14s %12.6g %12.6g %12.6g %12.6g %12.6g\n", stage.c_str(), grouped(lines).c_str(),
                      mean(b.emitted), mean(b.absorbed), mean(b.unshot), mean(b.escaped), mean(b.behind));
    };
    std::string text = format("stages     %14s %12s %12s %12s %12s %12s   (W, after the stage)\n", "lines", "emitted",
                              "absorbed", "unshot", "escaped", "behind");
    for (std::size_t k = 0; k < solution.shot_passes.size(); ++k)
        text += row("pass " + std::to_string(k + 1), solution.shot_passes[k].lines, solution.shot_passes[k].balance);
    const bool local = solution.global_lines == 0 && solution.shot_passes.empty();
    return text + row(local ? "particles" : "global pass", local ? solution.local_lines : solution.global_lines,
                      solution.balance);
}

JsonObject summary_json(const SolveSummary& s)
{
    const PowerBalance& balance = s.solution.balance;
    JsonObject json;
    json.text("scene", s.scene.path());
    json.text("scene_hash", format("%016llx", static_cast<unsigned long long>(s.scene.hash())));
    json.count("patches", s.scene.patch_count());
    json.count("surfaces", s.scene.own_surfaces());
    json.number("patch_size", s.scene.patch_size());
    json.number("area_m2", s.scene.own_area());
    json.number("average_reflectance", mean_reflectance(s.scene));
    json.number("source_power_w", mean(s.scene.source_power()));
    json.numbers("source_power_rgb_w", channels(s.scene.source_power()));
    json.text("unit", light_units(s.scene.file()).per_area);
    json.text("method", std::string(s.options.method->name));
    json.text("sequence", s.sequence);
    if (!has_option(s.options.method, "chords"))
        json.null("chords");
    else
        json.text("chords", name_of(chords_choices, chords_of(s.options)));
    json.count("seed", s.options.seed);
    json.count("lines", s.solution.local_lines + s.solution.global_lines);
    json.count("local_lines", s.solution.local_lines);
    json.count("global_lines", s.solution.global_lines);
    json.count("global_lines_cast", s.solution.global_lines_cast);
    json.number("mean_radiosity", mean(mean_radiosity(s)));
    json.numbers("mean_radiosity_rgb", channels(mean_radiosity(s)));
    json.number("emitted_power_w", mean(balance.emitted));
    json.number("emitted_power_error_w", balance.emitted_error);
    json.number("absorbed_power_w", mean(balance.absorbed));
    json.number("unshot_power_w", mean(balance.unshot));
    json.number("escaped_power_w", mean(balance.escaped));
    json.number("back_face_power_w", mean(balance.behind));
    json.number("balance_error", balance.relative_error());
    json.number("seconds", s.seconds);
    json.number("seconds_trace", s.seconds_trace);
    json.number("seconds_outputs", s.seconds_outputs);
    json.number("seconds_to_first_lines", s.seconds_to_first_lines);
    json.number("lines_per_second", lines_per_second(s));
    json.boolean("complete", s.complete);
    json.count("threads", static_cast<std::uint64_t>(s.options.threads));
    json.count("replicates", static_cast<std::uint64_t>(s.solution.replicates));
    json.count("all_lines", s.solution.all_lines);
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN(); // null
    json.number("relative_standard_error", s.solution.relative_standard_error.value_or(unknown));
    if (s.options.importance)
        json.number("important_relative_standard_error", s.error_of_important().value_or(unknown));
    json.number("patch_error", s.accuracy.patch_error.value_or(unknown));
    json.number("error", s.error().value_or(unknown));
    return json;
}

namespace {

/// True if every patch emits: such a scene looks right even if no lamp lights another.
bool everything_shines(const Scene& scene)
{
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (!(mean(scene.emittance(i)) > 0.0))
            return false;
    return true;
}

/// True if some surface sends more light than it emits. White ones absorb nothing, however bright they are.
bool reflects_light(const Scene& scene, const Solution& solution)
{
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (mean(solution.radiosity[i] - scene.emittance(i)) > 1e-9 * mean(solution.radiosity[i]))
            return true;
    return false;
}

/// Throws SettingsError or InputError, with the reason, if no light has reached any surface: a black picture is not a
/// result. `may_flip`: the command has the option --flip.
void require_light(const Scene& scene, const Solution& solution, bool may_flip, int threads)
{
    const PowerBalance& balance = solution.balance;
    if (!(mean(balance.absorbed + balance.escaped + balance.behind) > 0.0))
        throw SettingsError(
            scene.path() + ": none of " + grouped(solution.all_lines) + " lines left a source; " +
            (solution.all_lines < scene.patch_count() ? "expected more with --lines" : "see 'multipath check'"));
    const double rounding = 1e-9 * mean(balance.emitted); // line reuse gets some powers as differences
    if (mean(balance.absorbed) > rounding || reflects_light(scene, solution) || everything_shines(scene))
        return;
    if (solution.all_lines < scene.patch_count())
        throw SettingsError(scene.path() + ": " + grouped(solution.all_lines) +
                            " lines found no light on any surface; expected more with --lines");
    constexpr std::uint64_t lines_to_look = 1 << 16;
    const std::string dark = scene.path() + ": no light reaches any surface: ";
    if (mean(balance.behind) > rounding)
        throw InputError(dark + "it meets all of them from behind; --two-sided gives them backs");
    const bool inside_out =
        may_flip && is_inside_out(scene, survey_lines(scene, scene_hull(scene), lines_to_look, threads));
    throw InputError(dark + (inside_out ? "the scene is inside out; --flip turns all its faces over"
                                        : "the emitters face away from everything; see 'multipath check'"));
}

void require_error_to_show(const PictureOptions& pictures, const Accuracy& accuracy)
{
    if (pictures.shown.needs_replicates && accuracy.replicates < 2)
        throw UsageError("--show: a single run cannot estimate its error; expected --replicates, such as 4, or "
                         "--tolerance with --show " +
                         std::string(pictures.shown.name));
}

/// Throws InputError if the memory cannot hold the pictures. Without --output there are pictures, except for a shard.
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

void report_interruption(const SolveJob& job, const Solution& solution, const StateKeeper& keeper)
{
    print_note(format("interrupted after %s of %s lines%s\n", grouped(solution.all_lines).c_str(),
                      grouped(job.options.lines).c_str(),
                      keeper.path().empty() ? "; with --state FILE it could be resumed"
                                            : ("; --resume continues from " + keeper.path()).c_str()));
}

/// Reports the end of a shard. Returns the exit code.
int report_shard(const SolveJob& job, const StateKeeper& keeper)
{
    if (!job.quiet)
        print_note(format("%s; 'multipath merge' adds the shards up\n",
                          keeper.published() ? "this shard is done" : "interrupted; --resume continues this shard"));
    return keeper.published() ? 0 : exit_interrupted;
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
    const std::vector<std::string> comments = provenance(solve_command().table, job.line, scene);
    const PictureOptions pictures =
        has_view(outputs) ? with_camera(job.pictures, scene, solution.radiosity) : job.pictures;
    const auto page = [&] {
        Progress progress("solving with fewer lines, for the page", progress_style(job.line));
        return solution_page({scene, job.options, job.line.text("method"), job.sequence}, solution, pictures, comments,
                             [&](double done) { progress.show(done); });
    };
    SolvedScene solved(
        scene, solution, pictures, comments, [&] { return state; }, page);
    if (!job.quiet && has_view(outputs) && pictures.shown.is_room())
        print_note(black_picture_warning(scene, solved.shown_values(), pictures));
    write_outputs(outputs, solved);
    if (!job.quiet && job.pictures.grid)
        print_note(solved.grid_summary());
    if (!job.quiet)
        print_note(moved_coordinates_warning(outputs, scene));
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
                seconds_to_first_lines = seconds_since(job.start);
                watch_interrupts(); // from now on there are partial results
            }
            progress.show(done);
        };
        solution = solve_accurately(scene, job.options, job.accuracy, show, &keeper, shard);
    }
    const double seconds_trace = seconds_since(solve_start);
    if (keeper.stopped() && shard.of > 1) {
        write_results(job, scene, solution, outputs, keeper.last_bytes());
        return report_shard(job, keeper);
    }
    if (shard.of > 1 && job.options.method->shards == Shards::added)
        throw InputError("no work is left for shards; expected the same command without --shard, which does the rest");
    if (keeper.stopped())
        report_interruption(job, solution, keeper); // before the outputs, which a second signal may end
    else
        require_light(scene, solution, job.line.knows("flip"), job.options.threads);
    const SolveJob::Clock::time_point outputs_start = SolveJob::Clock::now();
    write_results(job, scene, solution, outputs, keeper.last_bytes());
    const double seconds_outputs = seconds_since(outputs_start);

    const SolveSummary summary{scene,
                               job.options,
                               solution,
                               job.sequence,
                               job.accuracy,
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
