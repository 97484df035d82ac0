#include "radiosity/paper/first_stage.h"

#include "base/errors.h"
#include "radiosity/paper/direct_light.h"
#include "radiosity/paper/line_budget.h"

namespace multipath {

namespace {

constexpr std::uint64_t rays_for_ratio = 1u
                                         << 13; // for the figures of (3); 2 % of the ratio do not matter to the error

FirstShot first_shot_of(const SolveOptions& options)
{
    return options.method->first_shot ? options.method->first_shot(options) : FirstShot::none;
}

} // namespace

double ratio_for(const Scene& scene, const SolveOptions& options)
{
    if (options.ratio)
        return *options.ratio;
    BudgetFigures figures;
    figures.intersections = intersections_of_hull_line(scene);
    figures.average_reflectance = mean(scene.average_reflectance());
    if (first_shot_of(options) == FirstShot::plain) {
        const DirectLight direct = measure_direct_light(scene, rays_for_ratio, options.threads);
        figures.secondary_reflectance = direct.secondary_reflectance;
        figures.lit_fraction = direct.lit_fraction;
    } else {
        figures = extended_figures(figures);
    }
    return optimal_ratio(figures).value_or(1.0); // (3)
}

ExtendedShotOptions extended_shot(const Scene& scene, const SolveOptions& options)
{
    ExtendedShotOptions shot;
    shot.threshold = options.threshold.value_or(threshold_radiosity(scene)); // (4)
    shot.most_steps = options.most_steps;
    shot.seed = options.seed;
    return shot;
}

std::vector<ShotPass> shoot_first(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                  const SolveOptions& options, const RunControl& run, PowerState& state,
                                  const PassObserver& observe)
{
    const FirstShot kind = first_shot_of(options);
    if (kind == FirstShot::none)
        return {};
    ExtendedShotOptions shot = extended_shot(scene, options);
    if (kind == FirstShot::plain)
        shot.most_steps = 1; // the first pass is the first shot
    shot.power_by_line = options.power_by_line;
    if (shot.power_by_line &&
        power_above(scene, state, shot.threshold) / *shot.power_by_line > static_cast<double>(options.lines))
        throw SettingsError(
            "rays of this power are more than the lines of the whole run; expected more power per line, or more lines");
    if (!shot.power_by_line)
        shot.lines = split_lines(options.lines, ratio_for(scene, options)).local_lines;
    return shoot_extended(scene, sequence, first_item, shot, run, state, observe); // (S1) (S2)
}

} // namespace multipath
