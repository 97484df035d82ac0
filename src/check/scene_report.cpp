// The figures of a scene come from three measurements: a survey of random global lines, which counts what light leaving
// each surface would meet; rays from the sources for the direct light; and a short trial run of the solver, whose power
// balance shows the power that is lost.

#include "check/scene_report.h"

#include "geometry/intersector/intersector.h"
#include "parallel/blocks.h"
#include "radiosity/run/solve.h"
#include "radiosity/run/trapped_light.h"
#include "transport/lines/depth_complexity.h"
#include "transport/lines/global_lines.h"

namespace multipath {

namespace {

LineSurvey empty_survey(const Scene& scene)
{
    const std::vector<std::uint64_t> zeros(scene.surfaces().size(), 0);
    return {0, 0, zeros, zeros, zeros};
}

/// Counts the fate of light that leaves the surface of hit `from` towards hit `to`, or towards nothing if `to` is
/// nullptr. `forward`: in the direction of the line, else against it.
void count_departure(const Scene& scene, const Hit& from, const Hit* to, bool forward, LineSurvey& survey)
{
    const bool leaves_front = from.front != forward;
    if (!leaves_front && !scene.two_sided())
        return;
    ++survey.departures[from.surface];
    if (to != nullptr && (to->front == forward || scene.two_sided()))
        ++survey.arrivals[from.surface];
    else if (to != nullptr)
        ++survey.met_behind[to->surface];
}

/// Counts the departures from all hits of a line, in both directions.
void count_line(const Scene& scene, const std::vector<Hit>& hits, LineSurvey& survey)
{
    for (std::size_t i = 0; i < hits.size(); ++i) {
        count_departure(scene, hits[i], i + 1 < hits.size() ? &hits[i + 1] : nullptr, true, survey);
        count_departure(scene, hits[i], i > 0 ? &hits[i - 1] : nullptr, false, survey);
    }
    survey.crossings += hits.size();
    ++survey.lines;
}

} // namespace

LineSurvey survey_lines(const Scene& scene, std::uint64_t lines, int threads)
{
    const GlobalLines global_lines(scene.bounds(), Chords::box);
    const std::unique_ptr<Sequence> sequence = make_sequence("random", 1);
    const Blocks blocks = {lines, 4096};
    BlockBuffers<LineSurvey> slots(threads, empty_survey(scene));
    const auto cast_block = [&](std::uint64_t block, int slot) {
        LineSurvey& survey = slots[slot];
        std::vector<Item> items(blocks.length(block));
        sequence->generate(blocks.first(block), items);
        std::vector<Hit> hits;
        for (const Item& item : items) {
            scene.intersector().all_hits(global_lines.line(item), hits);
            count_line(scene, hits, survey);
        }
    };
    ordered_blocks(blocks.count(), threads, cast_block, [](std::uint64_t, int) {});

    LineSurvey total = empty_survey(scene);
    for (const LineSurvey& survey : slots) { // counts: their order does not matter
        total.lines += survey.lines;
        total.crossings += survey.crossings;
        for (const auto counts : {&LineSurvey::departures, &LineSurvey::arrivals, &LineSurvey::met_behind})
            for (std::size_t i = 0; i < scene.surfaces().size(); ++i)
                (total.*counts)[i] += (survey.*counts)[i];
    }
    return total;
}

SceneReport report_on(const Scene& scene, std::uint64_t wanted_lines, int threads)
{
    SceneReport report;
    const std::uint64_t lines = affordable_lines(scene, wanted_lines);
    report.survey = survey_lines(scene, lines, threads);
    report.intersections_measured =
        static_cast<double>(report.survey.crossings) / static_cast<double>(report.survey.lines);
    report.direct = measure_direct_light(scene, lines, threads);
    report.figures = {intersections_per_line(scene), mean(scene.average_reflectance()),
                      report.direct.secondary_reflectance, report.direct.lit_fraction};
    report.ratio_first_shot = optimal_ratio(report.figures);
    report.ratio_extended = optimal_ratio(extended_figures(report.figures));
    report.threshold_radiosity = threshold_radiosity(scene);

    SolveOptions trial;
    trial.lines = lines;
    trial.ratio = 1.0;
    trial.threads = threads;
    report.trapped = patch_of_trapped_light(scene);
    if (!report.trapped)
        report.balance = solve(scene, Preparation(), trial, [](double) {}).balance;
    return report;
}

} // namespace multipath
