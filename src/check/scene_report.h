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

/// Counts of what global lines meet in a scene.
struct LineSurvey
{
    std::uint64_t lines = 0;           ///< chords of the sphere around the scene
    std::uint64_t hull_tests = 0;      ///< those of them that were tested against the convex hull of the scene
    std::uint64_t lines_into_hull = 0; ///< those of the tested ones that meet it
    std::uint64_t crossings = 0;       ///< of lines with surfaces

    // Counts per surface, of both directions of every line.
    std::vector<std::uint64_t> departures; ///< the line leaves a patch of the surface
    std::vector<std::uint64_t> arrivals;   ///< departures that reach another patch
    std::vector<std::uint64_t> escapes;    ///< departures that meet nothing
    std::vector<std::uint64_t> met_behind; ///< departures of any surface that meet this one on a side without a patch
    /// The line leaves the back of the surface, which has no patch, and meets the back of a surface that emits nothing.
    std::vector<std::uint64_t> back_to_back;
};

/// Casts `lines` random chords of the sphere and counts what they meet. `hull` is the convex hull of the scene.
/// Deterministic.
LineSurvey survey_lines(const Scene& scene, const ConvexHull& hull, std::uint64_t lines, int threads);

/// The figures of the paper for one scene, and the power balance of a short trial run.
struct SceneReport
{
    double hull_area = 0.0;   ///< [m^2]
    double sphere_area = 0.0; ///< [m^2] of the sphere around the scene's box

    double intersections_per_hull_line = 0.0;            ///< [1] n_int = 2 A_T' / A_hull (G2), A_T' each surface once
    double intersections_per_hull_line_measured = 0.0;   ///< [1] the same, counted along lines
    double intersections_per_sphere_line = 0.0;          ///< [1] 2 A_T' / A_sphere
    double intersections_per_sphere_line_measured = 0.0; ///< [1] the same, counted along lines

    DirectLight direct;
    BudgetFigures figures;                  ///< the inputs of (3) for the first shot
    std::optional<double> ratio_first_shot; ///< [1] N_l / N_g (3)
    std::optional<double> ratio_extended;   ///< [1] N_l / N_g (3) for the extended first shot
    double threshold_radiosity = 0.0;       ///< [W/m^2] (4)

    LineSurvey survey;
    std::uint64_t wanted_lines = 0; ///< as given to report_on
    std::uint64_t trial_lines = 0;  ///< lines of the trial run
    PowerBalance balance;           ///< of the trial run: shows the power that escapes or is lost at backs

    /// A patch among surfaces that light never leaves (see patch_of_trapped_light); if there is one, there is no trial
    /// run.
    std::optional<std::uint32_t> trapped;
};

/// Default number of lines of `check`. The report of `paper` takes as many, so that both print the same figures.
constexpr std::uint64_t report_lines = 1u << 20;

/// Measures each figure with about `wanted_lines` lines, or with fewer in scenes where hundreds of surfaces coincide or
/// follow each other along a line. Deterministic.
SceneReport report_on(const Scene& scene, std::uint64_t wanted_lines, int threads);

} // namespace multipath
