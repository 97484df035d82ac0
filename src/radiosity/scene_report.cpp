#include "radiosity/scene_report.h"

#include "radiosity/solve.h"
#include "radiosity/trapped_light.h"
#include "transport/depth_complexity.h"
#include "transport/line_sampling.h"

#include <algorithm>
#include <cmath>

namespace multipath {

SceneReport report_on(const Scene& scene, std::uint64_t wanted_lines, int threads)
{
    SceneReport report;
    const auto part = [&](double share) {
        return static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(wanted_lines)));
    };
    const std::uint64_t lines = part(affordable_lines(scene));
    const ConvexHull hull = scene_hull(scene);
    report.survey = survey_lines(scene, hull, lines, threads);
    report.hull_area = hull.area();
    report.sphere_area = GlobalLines(scene.bounds()).sphere_area();
    const auto crossings = static_cast<double>(report.survey.crossings);
    const double tested = static_cast<double>(report.survey.hull_tests) / static_cast<double>(report.survey.lines);
    const double into_hull = static_cast<double>(report.survey.lines_into_hull) / tested;
    report.intersections_per_hull_line = intersections_of_hull_line(scene, hull);
    report.intersections_per_hull_line_measured = into_hull > 0.0 ? crossings / into_hull : 0.0;
    report.intersections_per_sphere_line_measured = crossings / static_cast<double>(report.survey.lines);
    report.intersections_per_sphere_line = report.intersections_per_hull_line * report.hull_area / report.sphere_area;

    report.direct = measure_direct_light(scene, wanted_lines, threads);
    report.figures = {report.intersections_per_hull_line, mean(scene.average_reflectance()),
                      report.direct.secondary_reflectance, report.direct.lit_fraction};
    report.ratio_first_shot = optimal_ratio(report.figures);
    report.ratio_extended = optimal_ratio(extended_figures(report.figures));
    report.threshold_radiosity = threshold_radiosity(scene);

    SolveOptions trial;
    trial.lines = std::min(lines, part(affordable_source_rays(scene)));
    report.wanted_lines = wanted_lines;
    report.trial_lines = trial.lines;
    trial.ratio = 1.0;
    trial.threads = threads;
    report.trapped = patch_of_trapped_light(scene);
    if (!report.trapped)
        report.balance = solve(scene, trial, [](double) {}).balance;
    return report;
}

} // namespace multipath
