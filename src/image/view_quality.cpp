// A view is judged by a grid of rays, as if by a very small picture.

#include "image/view_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>

namespace multipath {

namespace {

constexpr double cells_along_size = 24.0; // cells of space that are counted to measure variety
constexpr double too_near = 0.08;         // share of the size

/// Importance of a surface in a picture: the root of its area, so that small objects are not neglected.
double weight(const Surface& surface)
{
    return std::sqrt(surface.area());
}

} // namespace

bool has_daylight(const Scene& scene)
{
    return scene.file().sky_surfaces > 0 || scene.file().sun;
}

LitScene::LitScene(const Scene& whole, const std::vector<Rgb>& solution, double diagonal)
    : scene(whole), radiosity(solution), size(diagonal)
{
    for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s)
        weight += multipath::weight(scene.surfaces()[s]);
    double power = 0.0;
    for (std::uint32_t i = 0; i < radiosity.size(); ++i)
        power += scene.is_sky_patch(i) ? 0.0 : scene.area(i) * mean(radiosity[i] - scene.emittance(i));
    usual_radiosity = power / scene.own_area();
}

bool LitScene::is_lit(std::uint32_t patch) const
{
    const double hardly_any = has_daylight(scene) ? 1e-3 : 0.02; // rooms are much darker than their surroundings
    return !scene.is_sky_patch(patch) &&
           (!(usual_radiosity > 0.0) || mean(radiosity[patch]) > hardly_any * usual_radiosity);
}

ViewQuality view_quality(const LitScene& lit_scene, const Camera& camera, double aspect, int rows)
{
    const Scene& scene = lit_scene.scene;
    constexpr double most_columns = 4096.0; // of extremely wide pictures the middle is judged
    const int columns = std::max(1, static_cast<int>(std::lround(std::min(most_columns, aspect * rows))));
    const PixelRays rays(camera, columns, rows);
    std::vector<Line> lines;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            lines.push_back(rays.through(x + 0.5, y + 0.5));
    VisibleHits visible(scene);
    const std::vector<std::optional<Hit>>& hits = visible.first(lines);
    const Vec3 low = scene.own_bounds().low;
    int escaped = 0;
    int backs = 0;
    int dark = 0;
    int near = 0;
    double brightness = 0.0; // 1 for each ray that ends at the usual radiosity or above
    std::set<std::array<double, 3>> cells;
    std::set<std::uint32_t> surfaces;
    std::set<std::uint32_t> materials;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        if (visible.nearest().is_hit(k) && !visible.nearest()[k].front && !scene.is_sky(visible.nearest()[k].surface))
            ++backs;
        if (!hits[k] || scene.is_sky(hits[k]->surface)) {
            ++escaped;
            continue;
        }
        const Hit& hit = *hits[k];
        near += hit.t < too_near * lit_scene.size ? 1 : 0;
        const std::uint32_t patch = scene.patch_at(hit.surface, hit.u, hit.v, hit.front);
        if (!lit_scene.is_lit(patch)) {
            ++dark;
            continue;
        }
        if (has_daylight(scene) && lit_scene.usual_radiosity > 0.0)
            brightness += std::min(1.0, mean(lit_scene.radiosity[patch]) / lit_scene.usual_radiosity);
        const Vec3 cell = (cells_along_size / lit_scene.size) * (lines[k].at(hit.t) - low);
        // The grid is shifted so that walls do not lie on the borders of cells.
        cells.insert({std::floor(cell.x + 0.382), std::floor(cell.y + 0.382), std::floor(cell.z + 0.382)});
        surfaces.insert(hit.surface);
        materials.insert(scene.file().material[hit.surface]);
    }
    double seen = 0.0;
    for (const std::uint32_t surface : surfaces)
        seen += weight(scene.surfaces()[surface]);

    // The weights are empirical.
    const double count = static_cast<double>(columns) * rows;
    const double variety = static_cast<double>(cells.size()) / count + seen / lit_scene.weight +
                           static_cast<double>(materials.size()) / static_cast<double>(scene.materials().size());
    const double flaws = 0.5 * escaped + 0.15 * backs + 2.0 * (dark + near);
    return {variety + (2.0 * brightness - flaws) / count, escaped / count, backs / count, dark / count};
}

} // namespace multipath
