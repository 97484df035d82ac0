#include "commands/solve/solve_summary.h"

#include "base/elementary.h"
#include "base/text_format.h"
#include "check/scene_report.h"
#include "commands/options/method_options.h"
#include "commands/solve/doubts.h"
#include "radiosity/run/statistics.h"
#include "scene/scene_file.h"

#include <cmath>
#include <vector>

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

} // namespace

std::optional<double> SolveSummary::error() const
{
    if (!job.accuracy.patch_error || !solution.relative_standard_error)
        return std::nullopt;
    return elementary::hypot(*job.accuracy.patch_error, *solution.relative_standard_error);
}

std::optional<double> SolveSummary::error_of_important() const
{
    if (!job.options.importance || solution.standard_error.empty())
        return std::nullopt;
    std::vector<double> weights = job.options.importance->weight;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        weights[i] *= scene.area(i);
    return std::sqrt(expected_relative_square(weights, solution.radiosity, solution.standard_error));
}

namespace {

std::string important_text(const SolveSummary& s)
{
    std::uint64_t patches = 0;
    for (const double weight : s.job.options.importance->weight)
        patches += weight > 0.0 ? 1 : 0;
    const std::optional<double> error = s.error_of_important();
    return format("important  %s patches%s\n", grouped(patches).c_str(),
                  error ? (": noise " + percent_text(*error) + " of their mean").c_str()
                        : "; --replicates estimates their error");
}

std::string warnings(const std::vector<std::string>& doubts)
{
    std::string text;
    for (const std::string& doubt : doubts)
        text += "warning    " + doubt + "\n";
    return text;
}

} // namespace

std::string summary_text(const SolveSummary& s)
{
    const PowerBalance& balance = s.solution.balance;
    const auto percent = [&](Rgb part) { return percent_of_emitted(balance, part); };
    const Rgb b = mean_radiosity(s);
    const std::string method(s.job.options.method->name);
    std::string text;
    text += format("scene      %s surfaces%s, %s patches, %.4g m^2, mean reflectance %.3f\n",
                   grouped(s.scene.own_surfaces()).c_str(), s.scene.file().sky_surfaces > 0 ? " and the sky" : "",
                   grouped(s.scene.patch_count()).c_str(), s.scene.own_area(), mean_reflectance(s.scene));
    text += format("method     %s, sequence %s: %s local + %s global lines\n", method.c_str(), s.job.sequence.c_str(),
                   grouped(s.solution.local_lines).c_str(), grouped(s.solution.global_lines).c_str());
    if (const std::optional<double> error = s.error())
        text += format("error      %s of the mean (patches %s, noise %s), by %d replicates%s\n",
                       percent_text(*error).c_str(), percent_text(*s.job.accuracy.patch_error).c_str(),
                       percent_text(*s.solution.relative_standard_error).c_str(), s.solution.replicates,
                       s.solution.all_lines > s.solution.local_lines + s.solution.global_lines
                           ? (" of the last round; " + grouped(s.solution.all_lines) + " lines in all rounds").c_str()
                           : "");
    if (s.job.options.importance)
        text += important_text(s);
    text += warnings(doubts_of_error(s));
    const LightUnits units = light_units(s.scene.file());
    text += format("radiosity  mean %.6g  (%.4g, %.4g, %.4g) %s\n", mean(b), b.r, b.g, b.b, units.per_area);
    text += format("power      emitted %.6g %s: %.2f %% absorbed, %.3f %% unshot, %.2f %% escaped, %.2f %% lost behind "
                   "surfaces; balance to %.0e\n",
                   mean(balance.emitted), units.power, percent(balance.absorbed), percent(balance.unshot),
                   percent(balance.escaped), percent(balance.behind), balance.relative_error());
    text += warnings(doubts_of_result(s));
    if (!s.all_at_once)
        return text + format("time       %.2f s, of this part of the run\n", s.seconds);
    text +=
        format("time       %.2f s, %.2f s of it tracing: %.2f million lines/s on %d thread%s; %.2f s for the outputs\n",
               s.seconds, s.seconds_trace, 1e-6 * lines_per_second(s), s.job.options.threads,
               s.job.options.threads == 1 ? "" : "s", s.seconds_outputs);
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
    const Rgb source = s.scene.source_power();
    const Rgb b = mean_radiosity(s);
    JsonObject json;
    json.text("scene", s.scene.path());
    json.text("scene_hash", format("%016llx", static_cast<unsigned long long>(s.scene.hash())));
    json.count("patches", s.scene.patch_count());
    json.count("surfaces", s.scene.own_surfaces());
    json.number("patch_size", s.scene.patch_size());
    json.number("area_m2", s.scene.own_area());
    json.number("average_reflectance", mean_reflectance(s.scene));
    json.number("source_power_w", mean(source));
    json.numbers("source_power_rgb_w", source);
    json.text("unit", light_units(s.scene.file()).per_area);
    json.text("method", std::string(s.job.options.method->name));
    json.text("sequence", s.job.sequence);
    const bool has_chords = has_option(s.job.options.method, "chords");
    has_chords ? json.text("chords", name_of(chords_choices, chords_of(s.job.options))) : json.null("chords");
    json.count("seed", s.job.options.seed);
    json.count("lines", s.solution.local_lines + s.solution.global_lines);
    json.count("local_lines", s.solution.local_lines);
    json.count("global_lines", s.solution.global_lines);
    json.count("global_lines_cast", s.solution.global_lines_cast);
    json.number("mean_radiosity", mean(b));
    json.numbers("mean_radiosity_rgb", b);
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
    json.count("threads", static_cast<std::uint64_t>(s.job.options.threads));
    json.count("replicates", static_cast<std::uint64_t>(s.solution.replicates));
    json.count("all_lines", s.solution.all_lines);
    json.number("relative_standard_error", s.solution.relative_standard_error);
    if (s.job.options.importance)
        json.number("important_relative_standard_error", s.error_of_important());
    json.number("patch_error", s.job.accuracy.patch_error);
    json.number("error", s.error());
    return json;
}

} // namespace multipath
