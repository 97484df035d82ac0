#pragma once

#include "radiosity/paper/direct_light.h"
#include "radiosity/paper/line_budget.h"
#include "radiosity/paper/power_state.h"
#include "scene/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// Counts of what global lines (random lines through the whole scene) meet in a scene. A surface has patches
/// on its front only, or on both sides in a two-sided scene.
struct LineSurvey
{
    std::uint64_t lines = 0;     ///< number of lines cast, all of which meet the bounding box of the scene
    std::uint64_t crossings = 0; ///< number of intersections of all lines with surfaces

    // Counts per surface. Every line counts in both directions.
    std::vector<std::uint64_t> departures; ///< times that a line leaves a patch of the surface
    std::vector<std::uint64_t> arrivals;   ///< departures from the surface that reach another patch
    std::vector<std::uint64_t> met_behind; ///< departures from any surface that meet this one on a side without a patch
};

/// Casts `lines` random lines through the bounding box of the scene and counts what they meet. Deterministic.
LineSurvey survey_lines(const Scene& scene, std::uint64_t lines, int threads);

/// The figures of the paper for one scene, and the power balance of a short trial run. Labels such as (G2) are those of
/// docs/equations.md.
struct SceneReport
{
    double intersections_measured = 0.0; ///< [1] per line of the survey; expected: figures.intersections

    DirectLight direct;                     ///< figures of the direct illumination
    BudgetFigures figures;                  ///< the inputs of (3) for the first shot
    std::optional<double> ratio_first_shot; ///< [1] optimal N_l / N_g (3); empty if any ratio is as good
    std::optional<double>
        ratio_extended; ///< [1] optimal N_l / N_g (3) for the extended first shot; empty if any is as good
    double threshold_radiosity = 0.0; ///< [W/m^2] radiosity (4) above which patches shoot in the first shot

    LineSurvey survey;
    PowerBalance balance; ///< balance of the trial run: shows the power that escapes or is lost at backs

    /// Index of a patch among surfaces that light never leaves (see patch_of_trapped_light). If there is such a patch,
    /// the trial run is omitted, and `balance` is zero.
    std::optional<std::uint32_t> trapped;
};

/// Default number of lines of `check`. The report of `paper` takes as many, so that both print the same figures.
constexpr std::uint64_t report_lines = 1u << 20;

/// Measures each figure with about `wanted_lines` >= 1 lines (affordable_lines), and the direct light also with shadow
/// rays (measure_direct_light). Deterministic; the result does not depend on `threads`.
SceneReport report_on(const Scene& scene, std::uint64_t wanted_lines, int threads);

} // namespace multipath
