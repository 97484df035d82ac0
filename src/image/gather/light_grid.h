#pragma once

#include "scene/rgb.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace multipath {

/// A horizontal measuring plane, such as the task area of a workplace (EN 12464-1).
struct GridPlan
{
    double height; ///< [m] above the lowest point of the scene without its sky
    double step;   ///< [m] largest distance between neighbouring points of a row or column
    Vec3 up;       ///< direction that the plane faces, not zero
};

/// A measuring point and the irradiance of the upper side of a horizontal surface there.
struct GridPointLight
{
    Vec3 point;
    Rgb irradiance; ///< [W/m^2]
};

/// Irradiance on a grid of points, the centres of equal rectangles over the scene. A point is left out if it is above
/// the scene, or if a ray straight down from it meets nothing or first meets the sky or a back that has no patches, or
/// if rays up and to four sides all first meet such backs: then the point lies in a wall, in furniture, which may have
/// no bottom, or outside the scene. A point on a surface, such as any of a grid of
/// height 0 on the floor, has the light that arrives there. `mean`, `least` and `most` are statistics of the mean of
/// the three channels.
struct LightGrid
{
    std::vector<GridPointLight> points; ///< row by row
    double mean = 0.0;                  ///< [W/m^2] mean over the points
    double least = 0.0;                 ///< [W/m^2] minimum over the points
    double most = 0.0;                  ///< [W/m^2] maximum over the points

    double uniformity() const { return mean > 0.0 ? least / mean : 0.0; } ///< [1] U_0 = minimum / mean
};

/// Computes the irradiance on a grid from a solution, radiosity [W/m^2] per patch. At each point, `rays` rays over the
/// upper hemisphere gather indirect light, and as many rays go to the sources. Sunlight is included. Throws
/// SettingsError if the grid has more than a million points before any is left out, or if none remains.
LightGrid light_grid(const Scene& scene, const std::vector<Rgb>& radiosity, const GridPlan& plan, int rays,
                     int threads);

/// The grid as CSV, a header and one row per point: x, y, z [m], irradiance [W/m^2] per channel, and the mean of the
/// channels.
std::string light_grid_table(const Scene& scene, const LightGrid& grid);

/// One line of statistics in the scene's light unit: "512 lx on average, least 301, most 820, uniformity 0.588, of 96
/// points".
std::string light_grid_summary(const Scene& scene, const LightGrid& grid);

} // namespace multipath
