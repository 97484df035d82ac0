#pragma once

#include "geometry/convex_hull.h"
#include "scene/scene.h"

#include <cstdint>
#include <optional>

namespace multipath {

/// Properties of a scene that enter the paper's formula (3). All are dimensionless.
struct BudgetFigures
{
    double intersections = 0.0;       ///< n_int, for a line that meets the convex hull of the scene (G2)
    double average_reflectance = 0.0; ///< R_ave
    double secondary_reflectance =
        0.0;                   ///< R_s', mean reflectance of the directly lit patches, weighted by the received power
    double lit_fraction = 0.0; ///< f, area of the directly lit patches / A_T
};

/// N_l / N_g, the optimal number of local lines per global line (3) [Sbe97a]. Empty if the sources light nothing that
/// reflects: any ratio is as good then.
std::optional<double> optimal_ratio(const BudgetFigures& figures);

/// The figures after an extended first shot, when all patches have received power: f = 1 and R_s' = R_ave.
BudgetFigures extended_figures(BudgetFigures figures);

/// Convex hull of all surfaces.
ConvexHull scene_hull(const Scene& scene);

/// n_int = 2 A_T / A_hull (G2).
double intersections_of_hull_line(const Scene& scene, const ConvexHull& hull);
double intersections_of_hull_line(const Scene& scene);

/// Radiosity that every patch keeps unshot in the (extended) first shot (4) [W/m^2]: the mean reflected radiosity of an
/// even distribution of the light. Infinite if nothing absorbs: then nothing is shot.
double threshold_radiosity(const Scene& scene);

/// Numbers of local and of global lines.
struct LineBudget
{
    std::uint64_t local_lines = 0;  ///< N_l
    std::uint64_t global_lines = 0; ///< N_g, lines that meet the scene's bounding box (N1)
};

/// Splits `lines` = N_l + N_g at N_l / N_g = ratio >= 0.
LineBudget split_lines(std::uint64_t lines, double ratio);

} // namespace multipath
