#include "image/view_quality.h"

#include "image/visible_hits.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

namespace {

constexpr double cells_along_diagonal = 24.0; // points of one cell of the scene count as one place
constexpr double too_near = 0.08;             // of the scene's diagonal

/// What the rays of one view met.
struct View
{
    int escaped = 0;
    int backs = 0;
    int near = 0;
    int floor = 0;   ///< surfaces that face up
    int ceiling = 0; ///< surfaces that face down
    std::vector<std::uint64_t> cells;
    std::vector<std::uint32_t> surfaces;
    std::vector<std::uint32_t> materials;
};

/// The number of the cell in which a point lies.
std::uint64_t cell_of(const Scene& scene, Vec3 point)
{
    const double size = scene.bounds().diagonal() / cells_along_diagonal;
    const Vec3 p = (1.0 / size) * (point - scene.bounds().low);
    std::uint64_t cell = 0;
    for (const double x : {p.x, p.y, p.z})
        cell = 64 * cell + static_cast<std::uint64_t>(std::clamp(x, 0.0, 63.0));
    return cell;
}

void look(const Scene& scene, const Line& ray, Vec3 up, VisibleHits& visible, View& view)
{
    const std::optional<Hit> nearest = scene.intersector().closest_hit(ray);
    if (nearest && !nearest->front)
        ++view.backs;
    const std::optional<Hit> hit = nearest && nearest->front ? nearest : visible.first(ray);
    if (!hit)
        ++view.escaped;
    if (!hit || !hit->front)
        return;
    if (hit->t < too_near * scene.bounds().diagonal())
        ++view.near;
    const double upward = dot(scene.surfaces()[hit->surface].normal(), up);
    view.floor += upward > 0.7 ? 1 : 0;
    view.ceiling += upward < -0.7 ? 1 : 0;
    view.materials.push_back(scene.file().material[hit->surface]);
    view.cells.push_back(cell_of(scene, ray.at(hit->t)));
    view.surfaces.push_back(hit->surface);
}

template <class T>
void keep_distinct(std::vector<T>& items)
{
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
}

/// Rises to one while the share of rays rises to what is enough, the first rays counting most.
double share_up_to(int count, double rays, double enough)
{
    return std::sqrt(std::min(1.0, count / (rays * enough)));
}

/// The root of the area: small things matter more to a picture than their area says.
double weight(const Surface& surface)
{
    return std::sqrt(surface.area());
}

} // namespace

ViewQuality view_quality(const Scene& scene, const Camera& camera, double aspect, int rows)
{
    const int columns = std::max(1, static_cast<int>(std::lround(aspect * rows)));
    const PixelRays rays(camera, columns, rows);
    const Vec3 up = normalized(camera.up);
    VisibleHits visible(scene);
    View view;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            look(scene, rays.through(x + 0.5, y + 0.5), up, visible, view);
    keep_distinct(view.cells);
    keep_distinct(view.surfaces);
    keep_distinct(view.materials);
    double seen = 0.0;
    for (const std::uint32_t surface : view.surfaces)
        seen += weight(scene.surfaces()[surface]);
    double all = 0.0;
    for (const Surface& surface : scene.surfaces())
        all += weight(surface);

    const double count = static_cast<double>(columns) * rows;
    const double variety = static_cast<double>(view.cells.size()) / count;
    const double completeness = seen / all;
    const double balance = 0.5 * share_up_to(view.floor, count, 0.25) + 0.2 * share_up_to(view.ceiling, count, 0.08);
    const double colours =
        0.8 * static_cast<double>(view.materials.size()) / static_cast<double>(scene.materials().size());
    const bool lamp = std::any_of(view.materials.begin(), view.materials.end(), [&](std::uint32_t material) {
        return scene.materials()[material].emittance != Rgb{};
    });
    const double flaws = 0.5 * view.escaped + 0.15 * view.backs + 2.0 * view.near;
    const double score = variety + completeness + balance + colours + (lamp ? 0.35 : 0.0) - flaws / count;
    return {score, view.escaped / count, view.backs / count};
}

} // namespace multipath
