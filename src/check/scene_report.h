#pragma once

#include "geometry/convex_hull.h"
#include "radiosity/direct_light.h"
#include "radiosity/line_budget.h"
#include "radiosity/power_state.h"
#include "scene/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// What global lines meet in a scene, counted.
struct LineSurvey
{
    std::uint64_t lines = 0;           ///< chords of the sphere around the scene
    std::uint64_t hull_tests = 0;      ///< of them, those compared with the convex hull of the scene
    std::uint64_t lines_into_hull = 0; ///< of these, those that meet it
    std::uint64_t crossings = 0;       ///< of lines with surfaces

    /// Per surface, in both directions of every line:
    std::vector<std::uint64_t> departures; ///< the line leaves a patch of it
    std::vector<std::uint64_t> arrivals;   ///< of the departures, those that reach another patch
    std::vector<std::uint64_t> escapes;    ///< of the departures, those that meet nothing
    std::vector<std::uint64_t> met_behind; ///< departures from anywhere that meet this surface where it has no patch
    std::vector<std::uint64_t>
        back_to_back; ///< the line leaves its back, which has no patch, and meets another such back
};

/// Casts `lines` random chords, always the same. `hull`: of the scene.
LineSurvey survey_lines(const Scene& scene, const ConvexHull& hull, std::uint64_t lines, int threads);

/// The numbers of the paper for one scene, and what a short trial run finds.
struct SceneReport
{
    double hull_area = 0.0;   ///< [m^2]
    double sphere_area = 0.0; ///< [m^2] of the sphere around the scene's box

    double intersections_per_hull_line = 0.0;            ///< [1] n_int = 2 A_T' / A_hull (G2), A_T' each surface once
    double intersections_per_hull_line_measured = 0.0;   ///< [1] the same, counted along lines
    double intersections_per_sphere_line = 0.0;          ///< [1] 2 A_T' / A_sphere
    double intersections_per_sphere_line_measured = 0.0; ///< [1]

    DirectLight direct;
    BudgetFigures figures;                  ///< what (3) takes for the first shot
    std::optional<double> ratio_first_shot; ///< [1] N_l / N_g (3)
    std::optional<double> ratio_extended;   ///< [1] N_l / N_g (3) for the extended first shot
    double threshold_radiosity = 0.0;       ///< [W/m^2] (4)

    LineSurvey survey;
    std::uint64_t wanted_lines = 0;
    std::uint64_t trial_lines = 0; ///< of a short run
    PowerBalance balance;          ///< of this run: what escapes and what is lost behind surfaces

    /// A patch among surfaces that light never leaves (see patch_of_trapped_light); then there is no trial run.
    std::optional<std::uint32_t> trapped;
};

/// The lines that `check` takes unless told otherwise. The paper's report takes as many, so that both print the same
/// figures.
constexpr std::uint64_t report_lines = 1u << 20;

/// Measures with about `wanted_lines` lines for each figure, always the same ones; with fewer where surfaces lie on or
/// behind each other by the hundred.
SceneReport report_on(const Scene& scene, std::uint64_t wanted_lines, int threads);

} // namespace multipath
