#pragma once

#include "scene/rgb.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace multipath {

/// A horizontal measuring plane, such as the task area of a work place (EN 12464-1).
struct GridPlan
{
    double height; ///< [m] above the lowest point of the scene
    double step;   ///< [m] largest distance between neighbouring points
    Vec3 up;
};

/// A measuring point and the irradiance of a horizontal surface there that faces up.
struct GridPointLight
{
    Vec3 point;
    Rgb irradiance; ///< [W/m^2]
};

/// Irradiance on a grid of points, the centres of equal rectangles over the scene. Points without a visible side of a
/// surface below them, which lie in walls, in furniture or outside the scene, are left out.
struct LightGrid
{
    std::vector<GridPointLight> points;
    double mean = 0.0;  ///< [W/m^2] over the points, of the mean of the channels
    double least = 0.0; ///< [W/m^2] minimum of the same
    double most = 0.0;  ///< [W/m^2] maximum of the same

    double uniformity() const { return mean > 0.0 ? least / mean : 0.0; } ///< [1] U_0 = minimum / mean
};

/// Computes the irradiance on a grid from a solution, radiosity [W/m^2] per patch, with `rays` rays over the upper
/// hemisphere of each point and as many to the sources. Throws SettingsError for more than a million points, or none.
LightGrid light_grid(const Scene& scene, const std::vector<Rgb>& radiosity, const GridPlan& plan, int rays,
                     int threads);

/// The grid as CSV, one row per point: x, y, z [m], irradiance [W/m^2] per channel and their mean.
std::string light_grid_table(const LightGrid& grid);

/// One line of statistics: "512 lx on average, least 301, most 820, uniformity 0.588, of 96 points".
std::string light_grid_summary(const Scene& scene, const LightGrid& grid);

} // namespace multipath
