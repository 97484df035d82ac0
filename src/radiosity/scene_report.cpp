#include "radiosity/scene_report.h"

#include "radiosity/solve.h"
#include "transport/line_sampling.h"

namespace multipath {

SceneReport report_on(const Scene& scene, std::uint64_t lines, int threads)
{
    SceneReport report;
    report.survey = survey_lines(scene, lines, threads);
    report.hull_area = scene_hull(scene).area();
    report.sphere_area = GlobalLines(scene.bounds()).sphere_area();
    const auto per = [](std::uint64_t count, std::uint64_t whole) {
        return whole == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(whole);
    };
    report.intersections_per_hull_line = intersections_of_hull_line(scene);
    report.intersections_per_hull_line_measured = per(report.survey.crossings, report.survey.lines_into_hull);
    report.intersections_per_sphere_line = report.intersections_per_hull_line * report.hull_area / report.sphere_area;
    report.intersections_per_sphere_line_measured = per(report.survey.crossings, report.survey.lines);

    report.direct = measure_direct_light(scene, lines, threads);
    report.figures = {report.intersections_per_hull_line, mean(scene.average_reflectance()),
                      report.direct.secondary_reflectance, report.direct.lit_fraction};
    report.ratio_first_shot = optimal_ratio(report.figures);
    report.ratio_extended = optimal_ratio(extended_figures(report.figures));
    report.threshold_radiosity = threshold_radiosity(scene);

    SolveOptions trial;
    trial.lines = lines;
    trial.ratio = 1.0;
    trial.threads = threads;
    report.balance = solve(scene, trial, [](double) {}).balance;
    return report;
}

} // namespace multipath
