#include "image/gather/light_grid.h"

#include "base/errors.h"
#include "base/text_format.h"
#include "geometry/bounds.h"
#include "image/gather/gather_point.h"
#include "image/gather/indirect_light.h"
#include "image/gather/source_light.h"
#include "parallel/blocks.h"
#include "sampling/random.h"
#include "scene/scene_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace multipath {

namespace {

/// Orthonormal axes of a grid.
struct GridAxes
{
    Vec3 up;
    Vec3 along_x;
    Vec3 along_y;

    explicit GridAxes(Vec3 direction) : up(normalized(direction))
    {
        const Vec3 aside = std::abs(up.z) < 0.9 ? Vec3{0.0, 0.0, 1.0} : Vec3{0.0, 1.0, 0.0};
        along_x = normalized(cross(aside, up));
        along_y = cross(up, along_x);
    }
};

/// The bounding box of the scene without its sky along the axes x, y and up of a grid.
Bounds extent(const Scene& scene, const GridAxes& axes)
{
    Bounds box;
    for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s)
        for (const Vec3 corner : corners_of(scene.surfaces()[s]))
            box.include(Vec3{dot(corner, axes.along_x), dot(corner, axes.along_y), dot(corner, axes.up)});
    return box;
}

/// Middle of part k of `count` equal parts of an interval.
double middle_of_part(double low, double high, double k, double count)
{
    return low + (high - low) * (k + 0.5) / count;
}

/// Where to measure the light of a point: there, or `hair` above it if the point lies on a surface. Nothing if a ray
/// downwards does not first meet a side of a surface that has patches, or if rays upwards and to four sides all first
/// meet sides that have none: the point lies in a body, which may have no bottom.
std::optional<Vec3> place_above_floor(const Scene& scene, Vec3 point, const GridAxes& axes, double hair)
{
    const Vec3 raised = point + hair * axes.up;
    const auto first_hit = [&](Vec3 direction) { return scene.intersector().closest_hit({raised, direction}); };
    const auto is_back = [&](const std::optional<Hit>& hit) { return hit && !hit->front && !scene.two_sided(); };
    const std::optional<Hit> below = first_hit(-axes.up);
    if (!below || scene.is_sky(below->surface) || is_back(below))
        return std::nullopt;
    const std::array others = {axes.up, axes.along_x, -axes.along_x, axes.along_y, -axes.along_y};
    if (std::all_of(others.begin(), others.end(), [&](Vec3 direction) { return is_back(first_hit(direction)); }))
        return std::nullopt;
    return below->t <= 2.0 * hair ? raised : point;
}

} // namespace

LightGrid light_grid(const Scene& scene, const std::vector<Rgb>& radiosity, const GridPlan& plan, int rays, int threads)
{
    constexpr double most_points = 1e6;
    const GridAxes axes(plan.up);
    const Bounds box = extent(scene, axes);
    const double level = box.low.z + plan.height;
    const double columns = std::max(1.0, std::ceil(box.size().x / plan.step - 1e-9));
    const double rows = std::max(1.0, std::ceil(box.size().y / plan.step - 1e-9));
    if (!(columns * rows <= most_points))
        throw SettingsError("the grid has more than a million points; expected a larger step");
    const double hair = 1e-6 * scene.own_bounds().diagonal();
    LightGrid grid;
    std::vector<Vec3> places; // of the points
    const bool inside = level >= box.low.z && level < box.high.z;
    for (double j = 0.0; inside && j < rows; j += 1.0)
        for (double i = 0.0; i < columns; i += 1.0) {
            const Vec3 point = middle_of_part(box.low.x, box.high.x, i, columns) * axes.along_x +
                               middle_of_part(box.low.y, box.high.y, j, rows) * axes.along_y + level * axes.up;
            if (const std::optional<Vec3> place = place_above_floor(scene, point, axes, hair)) {
                grid.points.push_back({point, {}});
                places.push_back(*place);
            }
        }
    if (grid.points.empty())
        throw SettingsError("no point lies above a surface at the height of the grid; expected one within the scene");
    const SourceLight sources(scene);
    const IndirectLight indirect(scene, radiosity, rays, threads);
    parallel_blocks(grid.points.size(), threads, [&](std::uint64_t k) {
        const std::uint64_t bits = random_bits(random_key(RandomStream::light_grid), k);
        grid.points[k].irradiance = indirect.irradiance({GatherPoint::free, places[k], axes.up}, sources, bits);
    });
    grid.least = std::numeric_limits<double>::infinity();
    for (const GridPointLight& point : grid.points) {
        const double light = mean(point.irradiance);
        grid.mean += light / static_cast<double>(grid.points.size());
        grid.least = std::min(grid.least, light);
        grid.most = std::max(grid.most, light);
    }
    return grid;
}

std::string light_grid_summary(const Scene& scene, const LightGrid& grid)
{
    return format("%.4g %s on average, least %.4g, most %.4g, uniformity %.3f, of %zu points", grid.mean,
                  light_units(scene.file()).per_area, grid.least, grid.most, grid.uniformity(), grid.points.size());
}

std::string light_grid_table(const Scene& scene, const LightGrid& grid)
{
    const int digits = coordinate_digits(scene.own_bounds(), 9);
    std::string text = "x,y,z,irradiance_r,irradiance_g,irradiance_b,irradiance\n";
    for (const GridPointLight& p : grid.points)
        text += format("%.*g,%.*g,%.*g,%.9g,%.9g,%.9g,%.9g\n", digits, p.point.x, digits, p.point.y, digits, p.point.z,
                       p.irradiance.r, p.irradiance.g, p.irradiance.b, mean(p.irradiance));
    return text;
}

} // namespace multipath
