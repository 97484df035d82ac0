#include "radiosity/paper/line_budget.h"

#include <cmath>

namespace multipath {

std::optional<double> optimal_ratio(const BudgetFigures& figures)
{
    const double n_int = figures.intersections;
    const double r_ave = figures.average_reflectance;
    const double r_s = figures.secondary_reflectance;
    const double f = figures.lit_fraction;
    if (!(f > 0.0) || !(r_s > 0.0))
        return std::nullopt;
    return std::sqrt(n_int * (1.0 - r_ave * r_ave) * (1.0 - r_ave) /
                     (r_s * r_s * (1.0 - r_ave) / f + 2.0 * r_s * r_s * r_s)); // (3)
}

BudgetFigures extended_figures(BudgetFigures figures)
{
    figures.lit_fraction = 1.0;
    figures.secondary_reflectance = figures.average_reflectance;
    return figures;
}

double intersections_per_line(const Scene& scene)
{
    const double area =
        scene.total_area() / (scene.two_sided() ? 2.0 : 1.0); // a crossing counts once, however many sides have patches
    return 2.0 * area / scene.bounds().area();                // (G2)
}

double threshold_radiosity(const Scene& scene)
{
    const double r_ave = mean(scene.average_reflectance());
    return r_ave * mean(scene.source_power()) / (scene.total_area() * (1.0 - r_ave)); // (4)
}

std::uint64_t local_line_count(std::uint64_t lines, double ratio)
{
    return static_cast<std::uint64_t>(std::llround(static_cast<double>(lines) * ratio / (1.0 + ratio)));
}

} // namespace multipath
