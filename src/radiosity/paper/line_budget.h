#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <optional>

namespace multipath {

/// Properties of a scene that enter the optimal ratio. All are dimensionless.
struct BudgetFigures
{
    double intersections = 0.0;       ///< n_int: expected crossings of a line that meets the bounding box of the scene
    double average_reflectance = 0.0; ///< R_ave
    /// R_s': mean reflectance of the directly lit patches, weighted by the power that they receive from the sources.
    double secondary_reflectance = 0.0;
    double lit_fraction = 0.0; ///< f: area of the directly lit patches over the total area
};

/// N_l / N_g, the optimal number of local lines per global line (Sbert 1997; (3) in docs/equations.md). std::nullopt if
/// the sources light nothing that reflects: any ratio is as good then.
std::optional<double> optimal_ratio(const BudgetFigures& figures);

/// The figures after an extended first shot, when all patches have received power: f = 1 and R_s' = R_ave.
BudgetFigures extended_figures(BudgetFigures figures);

/// n_int = 2 A_T / A_box, with A_T the total area of the surfaces, each counted once, and A_box that of the bounding
/// box ((G2) in docs/equations.md). N_g counts the lines that meet this box, too (N1).
double intersections_per_line(const Scene& scene);

/// [W/m^2] Radiosity that every patch keeps unshot in the first shot and the extended first shot: the mean reflected
/// radiosity if the light were evenly distributed ((4) in docs/equations.md), with the means of the channels of power
/// and reflectance. Infinite if nothing absorbs: then nothing is shot.
double threshold_radiosity(const Scene& scene);

/// N_l, the number of local lines if `lines` = N_l + N_g lines have the ratio N_l / N_g = ratio >= 0, rounded to a
/// whole number. N_g counts lines that meet the scene's bounding box (N1).
std::uint64_t local_line_count(std::uint64_t lines, double ratio);

} // namespace multipath
