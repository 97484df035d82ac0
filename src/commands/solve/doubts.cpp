#include "commands/solve/doubts.h"

#include "base/text_format.h"
#include "check/scene_report.h"
#include "commands/options/method_options.h"
#include "radiosity/reuse/balanced_reuse.h"
#include "radiosity/run/replicates.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

std::uint64_t all_lines(const SolveSummary& s)
{
    return s.solution.local_lines + s.solution.global_lines;
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

/// Doubts of runs with few lines.
std::vector<std::string> doubts_of_lines(const SolveSummary& s)
{
    const std::uint64_t lines = all_lines(s);
    const std::uint64_t enough_for_reuse = // in all replicates, with a table of pairs or without
        static_cast<std::uint64_t>(s.solution.replicates) * min_balanced_rays(s.scene);
    constexpr std::uint64_t few_per_patch = 16;
    std::vector<std::string> doubts;
    if (s.job.options.method == Method::reuse && s.complete && s.solution.global_lines == 0 && lines < enough_for_reuse)
        doubts.push_back("too few lines for reuse: particles carried the light, with more noise; " +
                         grouped(enough_for_reuse) + " lines are enough");
    else if (lines < few_per_patch * s.scene.patch_count())
        doubts.push_back(format("only %.2g lines per patch, and neighbours differ by noise; --lines %s gives each 24",
                                static_cast<double>(lines) / s.scene.patch_count(), usual_lines(s.scene).c_str()));
    if (s.solution.by_particles)
        doubts.push_back(std::string(s.job.options.method->name) + " finds no sound solution with these lines: " +
                         "particles carried the light, with more noise; more lines help");
    return doubts;
}

/// Doubts of runs whose power does not arrive as it should.
std::vector<std::string> doubts_of_power(const SolveSummary& s)
{
    const PowerBalance& balance = s.solution.balance;
    const double unshot = percent_of_emitted(balance, balance.unshot);
    const double behind = percent_of_emitted(balance, balance.behind);
    const double emitted_too_much = std::abs(mean(balance.emitted) - mean(balance.source));
    std::vector<std::string> doubts;
    if (balance.emitted_error > 0.0 && emitted_too_much > 4.0 * balance.emitted_error)
        doubts.push_back(format(
            "the lines sent %.4g %s of %.4g, and noise explains a difference of only %.2g: they are "
            "not uniform, and the result is wrong to the same degree",
            mean(balance.emitted), light_units(s.scene.file()).power, mean(balance.source), balance.emitted_error));
    if (unshot > 5.0)
        doubts.push_back(percent_text(0.01 * unshot) +
                         " of the power is not distributed yet, which makes the result too dark; more lines help");
    else if (const double growth = growth_by_unshot_light(s); growth > 0.1)
        doubts.push_back("the power that is not distributed yet is on surfaces that reflect nearly all of it, and may "
                         "make the result brighter by " +
                         percent_text(growth) + "; more lines help, or --method reuse");
    // Patches that lie partly under objects send some light into these. The sky also shines on outer sides.
    if (behind > 0.1 && !s.scene.file().sky_surfaces)
        doubts.push_back(format("%.3g %% of the power met surfaces from behind and is lost; 'multipath check' names "
                                "them, --two-sided gives them backs",
                                behind));
    return doubts;
}

} // namespace

std::vector<std::string> doubts_of_error(const SolveSummary& s)
{
    std::vector<std::string> doubts;
    if (s.job.accuracy.tolerance && s.error() > *s.job.accuracy.tolerance)
        doubts.push_back(
            format("that is above the tolerance of %.3g %%: ", 100.0 * *s.job.accuracy.tolerance) +
            (*s.job.accuracy.patch_error > s.job.accuracy.patch_tolerance()
                 ? "there are too few patches, because of options, of the time, or of the limit of a million"
                 : "the limit of lines or time was reached"));
    if (s.solution.relative_standard_error &&
        all_lines(s) < lines_for_error_estimate(s.scene, s.job.options.method, s.solution.replicates))
        doubts.push_back(format("with fewer than %d lines per patch in each replicate it may be several times larger; "
                                "more lines or fewer replicates help",
                                static_cast<int>(s.job.options.method->lines_per_patch(s.scene))));
    return doubts;
}

std::vector<std::string> doubts_of_result(const SolveSummary& s)
{
    return concatenated({doubts_of_lines(s), doubts_of_power(s)});
}

double percent_of_emitted(const PowerBalance& balance, Rgb part)
{
    const double share = 100.0 * mean(part) / mean(balance.emitted);
    return std::abs(share) < 5e-4 ? 0.0 : share; // avoids "-0.000"
}

std::string percent_text(double share)
{
    const double percent = 100.0 * share;
    return format(percent < 99.5 ? "%.2g %%" : "%.0f %%", percent);
}

} // namespace multipath
