#pragma once

#include "geometry/convex_hull.h"
#include "scene/scene.h"

#include <cstdint>
#include <optional>

namespace multipath {

/// What the paper's formula (3) needs to know of a scene; all [1].
struct BudgetFigures
{
    double intersections = 0.0;         ///< n_int, of a line that meets the scene's convex hull (G2)
    double average_reflectance = 0.0;   ///< R_ave
    double secondary_reflectance = 0.0; ///< R_s', of what the sources light, weighted by the power that it receives
    double lit_fraction = 0.0;          ///< f, area of the patches that the sources light / A_T
};

/// N_l / N_g, local lines per global line (3) [Sbe97a]. Empty where the sources light nothing that reflects: then any
/// ratio does.
std::optional<double> optimal_ratio(const BudgetFigures& figures);

/// The figures for the extended first shot: after it all patches are taken to have received power, so f = 1 and R_s' =
/// R_ave.
BudgetFigures extended_figures(BudgetFigures figures);

/// The convex hull of all surfaces.
ConvexHull scene_hull(const Scene& scene);

/// n_int = 2 A_T / A_hull (G2).
double intersections_of_hull_line(const Scene& scene, const ConvexHull& hull);
double intersections_of_hull_line(const Scene& scene);

/// The radiosity that every patch keeps unshot in the (extended) first shot (4) [W/m^2]: the mean reflected radiosity
/// that an even distribution would give. Infinite when nothing absorbs: then nothing is shot.
double threshold_radiosity(const Scene& scene);

/// How many lines of each kind.
struct LineBudget
{
    std::uint64_t local_lines = 0;  ///< N_l
    std::uint64_t global_lines = 0; ///< N_g, lines that meet the scene's bounding box (N1)
};

/// Splits `lines` = N_l + N_g at N_l / N_g = ratio >= 0.
LineBudget split_lines(std::uint64_t lines, double ratio);

} // namespace multipath
