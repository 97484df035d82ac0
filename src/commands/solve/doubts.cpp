#include "commands/solve/doubts.h"

#include "base/text_format.h"
#include "check/scene_report.h"
#include "commands/options/method_options.h"
#include "radiosity/paper/line_budget.h"
#include "radiosity/reuse/balanced_reuse.h"
#include "radiosity/run/replicates.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace multipath {

namespace {

/// A condition that makes a result doubtful, and the text that says so.
struct Check
{
    bool (*fails)(const SolveSummary&);
    std::string (*text)(const SolveSummary&);
};

std::uint64_t all_lines(const SolveSummary& s)
{
    return s.solution.local_lines + s.solution.global_lines;
}

/// Lines of all replicates that are enough for line reuse, with a table of pairs or without.
std::uint64_t enough_for_reuse(const SolveSummary& s)
{
    return static_cast<std::uint64_t>(s.solution.replicates) * min_balanced_rays(s.scene);
}

bool is_too_few_for_reuse(const SolveSummary& s)
{
    return s.options.method == Method::reuse && s.complete && s.solution.global_lines == 0 &&
           all_lines(s) < enough_for_reuse(s);
}

double unshot_percent(const SolveSummary& s)
{
    return percent_of_emitted(s.solution.balance, s.solution.balance.unshot);
}

bool is_mostly_shot(const SolveSummary& s)
{
    return !(unshot_percent(s) > 5.0);
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

constexpr std::array error_checks = {
    Check{[](const SolveSummary& s) { return s.accuracy.tolerance && s.error() > *s.accuracy.tolerance; },
          [](const SolveSummary& s) {
              return format("that is above the tolerance of %.3g %%: %s", 100.0 * *s.accuracy.tolerance,
                            *s.accuracy.patch_error > s.accuracy.patch_tolerance()
                                ? "there are too few patches; up to a million are chosen if no option fixes them"
                                : "the limit of lines or time was reached");
          }},
    Check{[](const SolveSummary& s) {
              return s.solution.relative_standard_error &&
                     all_lines(s) < lines_for_error_estimate(s.scene, s.options.method, s.solution.replicates);
          },
          [](const SolveSummary& s) {
              return format(
                  "with fewer than %d lines per patch in each replicate the error may be several times larger "
                  "than this; more lines or fewer replicates help",
                  static_cast<int>(s.options.method->lines_per_patch(s.scene)));
          }}};

constexpr std::array result_checks = {
    Check{is_too_few_for_reuse,
          [](const SolveSummary& s) {
              return format("too few lines per patch for line reuse: particles carried the light, with more noise; %s "
                            "lines are enough for reuse",
                            grouped(enough_for_reuse(s)).c_str());
          }},
    Check{[](const SolveSummary& s) {
              constexpr std::uint64_t few = 16; // per patch
              return !is_too_few_for_reuse(s) && all_lines(s) < few * s.scene.patch_count();
          },
          [](const SolveSummary& s) {
              return format("only %.2g lines per patch, and neighbours differ by noise; --lines %s gives each patch 24 "
                            "or more",
                            static_cast<double>(all_lines(s)) / s.scene.patch_count(), usual_lines(s.scene).c_str());
          }},
    Check{[](const SolveSummary& s) { return s.solution.by_particles; },
          [](const SolveSummary& s) {
              return format(
                  "method %s finds no sound solution with these lines: particles carried the light, with more "
                  "noise; more lines help",
                  std::string(s.options.method->name).c_str());
          }},
    Check{[](const SolveSummary& s) {
              const PowerBalance& balance = s.solution.balance;
              return balance.emitted_error > 0.0 &&
                     std::abs(mean(balance.emitted) - mean(balance.source)) > 4.0 * balance.emitted_error;
          },
          [](const SolveSummary& s) {
              const PowerBalance& balance = s.solution.balance;
              return format(
                  "the lines sent %.4g %s, but the sources emit %.4g, and noise explains a difference of only "
                  "%.2g: these lines are not uniform, and the result is wrong to the same degree",
                  mean(balance.emitted), light_units(s.scene.file()).power, mean(balance.source),
                  balance.emitted_error);
          }},
    Check{
        [](const SolveSummary& s) { return !is_mostly_shot(s); },
        [](const SolveSummary& s) {
            return percent_text(0.01 * unshot_percent(s)) +
                   " of the power is not distributed yet, which makes the result too dark; more lines help, or larger "
                   "patches";
        }},
    Check{[](const SolveSummary& s) { return is_mostly_shot(s) && growth_by_unshot_light(s) > 0.1; },
          [](const SolveSummary& s) {
              return format("the %s of the power that is not distributed yet is on surfaces that reflect nearly all of "
                            "it, and may make the result brighter by %s; more lines help, or --method reuse",
                            percent_text(0.01 * unshot_percent(s)).c_str(),
                            percent_text(growth_by_unshot_light(s)).c_str());
          }},
    Check{[](const SolveSummary& s) { // the sky also shines on outer sides
              return percent_of_emitted(s.solution.balance, s.solution.balance.behind) > 0.01 &&
                     !s.scene.file().sky_surfaces;
          },
          [](const SolveSummary& s) {
              return format(
                  "%.3g %% of the power met surfaces from behind and is lost, which makes the result too dark; "
                  "'multipath check' names them, --two-sided gives them backs",
                  percent_of_emitted(s.solution.balance, s.solution.balance.behind));
          }}};

template <typename Checks>
std::vector<std::string> failed(const Checks& checks, const SolveSummary& summary)
{
    std::vector<std::string> texts;
    for (const Check& check : checks)
        if (check.fails(summary))
            texts.push_back(check.text(summary));
    return texts;
}

} // namespace

std::vector<std::string> doubts_of_error(const SolveSummary& summary)
{
    return failed(error_checks, summary);
}

std::vector<std::string> doubts_of_result(const SolveSummary& summary)
{
    return failed(result_checks, summary);
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
