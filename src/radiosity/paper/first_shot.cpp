#include "radiosity/paper/first_shot.h"

#include "base/errors.h"
#include "radiosity/paper/direct_light.h"
#include "radiosity/paper/line_budget.h"
#include "radiosity/paper/measured_ratio.h"
#include "radiosity/run/run.h"
#include "transport/lines/depth_complexity.h"

#include <algorithm>

namespace multipath {

namespace {

/// For the figures of (3). f and with it the ratio come out a little low (docs/equations.md), but the error as a
/// function of the ratio has a wide minimum.
constexpr std::uint64_t rays_for_ratio = 1u << 13;

FirstShot first_shot_of(const SolveOptions& options)
{
    const bool gathers = options.method == Method::reuse && options.direct == Direct::gather;
    return gathers ? FirstShot::none : options.method->first_shot;
}

ExtendedShotOptions shot_options(const Scene& scene, const SolveOptions& options)
{
    ExtendedShotOptions shot;
    shot.threshold = options.threshold.value_or(threshold_radiosity(scene)); // (4)
    shot.most_steps =
        first_shot_of(options) == FirstShot::plain ? 1 : options.most_steps; // the first pass is the first shot
    shot.seed = options.seed;
    return shot;
}

/// The ratio that a pilot of the first shot shows to be best.
std::optional<double> ratio_by_pilot(const Scene& scene, const SolveOptions& options)
{
    const std::unique_ptr<Sequence> sequence = make_line_sequence(options.sequence, options.seed, options.pairing);
    // With less than a ray for each patch the passes would shoot nearly everything, and leave little to the walk.
    const std::uint64_t rays =
        std::clamp<std::uint64_t>(options.lines / 16, 1, std::max<std::uint64_t>(4096, 2ull * scene.patch_count()));
    PilotShot pilot{PowerState(scene), {}};
    pilot.passes =
        shoot_pilot(scene, *sequence, options.skip, shot_options(scene, options), rays, options.threads, pilot.after);
    const WalkDensity walk = walk_density(scene, GlobalLines(scene.bounds(), chords_of(options)), *sequence,
                                          options.skip, options.bidirectional);
    return best_ratio(line_variances(scene, pilot, walk)); // (V1) (V2)
}

} // namespace

double ratio_for(const Scene& scene, const SolveOptions& options)
{
    if (options.ratio)
        return *options.ratio;
    if (options.measured_ratio)
        return ratio_by_pilot(scene, options).value_or(1.0);
    BudgetFigures figures;
    figures.intersections = intersections_per_line(scene);
    figures.average_reflectance = mean(scene.average_reflectance());
    if (first_shot_of(options) == FirstShot::plain) {
        const DirectLight direct =
            measure_direct_light(scene, affordable_lines(scene, rays_for_ratio), options.threads);
        figures.secondary_reflectance = direct.secondary_reflectance;
        figures.lit_fraction = direct.lit_fraction;
    } else {
        figures = extended_figures(figures);
    }
    return optimal_ratio(figures).value_or(1.0); // (3)
}

void shoot_first(Run& run, const PassObserver& observe)
{
    const SolveOptions& options = run.options;
    if (first_shot_of(options) == FirstShot::none)
        return;
    ExtendedShotOptions shot = shot_options(run.scene, options);
    shot.power_by_line = options.power_by_line;
    if (shot.power_by_line &&
        power_above(run.scene, run.state, shot.threshold) / *shot.power_by_line > static_cast<double>(options.lines))
        throw SettingsError(
            "rays of this power are more than the lines of the whole run; expected more power per line, or more lines");
    shot.lines = shot.power_by_line ? options.lines : local_line_count(options.lines, ratio_for(run.scene, options));
    run.solution.shot_passes = shoot_extended(run.scene, *run.sequence, run.next_item(), shot, run.control(1, 1),
                                              run.state, observe); // (S1) (S2)
    for (const ShotPass& pass : run.solution.shot_passes)
        run.solution.local_lines += pass.lines;
}

} // namespace multipath
