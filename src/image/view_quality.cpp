#include "image/view_quality.h"

#include "image/visible_hits.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace multipath {

namespace {

constexpr double cells_along_diagonal = 24.0; // points of one cell of the scene count as one place
constexpr double too_near = 0.08;             // of the scene's diagonal
constexpr double in_the_dark = 0.02;          // of the reflected power: the sides that share it count as dark

/// What the rays of one view met.
struct View
{
    int escaped = 0;
    int backs = 0;
    int dark = 0;
    int near = 0;
    int floor = 0;   ///< surfaces that face up
    int ceiling = 0; ///< surfaces that face down
    std::vector<std::uint64_t> cells;
    std::vector<std::uint32_t> surfaces;
    std::vector<std::uint32_t> materials;
};

/// The number of the cell in which a point lies.
std::uint64_t cell_of(const Bounds& box, Vec3 point)
{
    const double size = box.diagonal() / cells_along_diagonal;
    const Vec3 p = (1.0 / size) * (point - box.low);
    std::uint64_t cell = 0;
    for (const double x : {p.x, p.y, p.z})
        cell = 64 * cell + static_cast<std::uint64_t>(std::clamp(x, 0.0, 63.0));
    return cell;
}

void look(const LitScene& sight, const Line& ray, Vec3 up, VisibleHits& visible, View& view)
{
    const Scene& scene = sight.scene;
    const std::optional<Hit> nearest = scene.intersector().closest_hit(ray);
    if (nearest && !nearest->front)
        ++view.backs;
    const std::optional<Hit> hit = nearest && nearest->front ? nearest : visible.first(ray);
    if (!hit)
        ++view.escaped;
    const bool dark = hit && !sight.is_lit[scene.patch_at(hit->surface, hit->u, hit->v, hit->front)];
    view.dark += dark ? 1 : 0;
    if (!hit || !hit->front || dark)
        return;
    if (hit->t < too_near * sight.box.diagonal())
        ++view.near;
    const double upward = dot(scene.surfaces()[hit->surface].normal(), up);
    view.floor += upward > 0.7 ? 1 : 0;
    view.ceiling += upward < -0.7 ? 1 : 0;
    view.materials.push_back(scene.file().material[hit->surface]);
    view.cells.push_back(cell_of(sight.box, ray.at(hit->t)));
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

/// One side of a surface.
struct LitSide
{
    std::uint32_t first_patch;
    std::uint32_t end_patch;
    double radiosity; ///< [W/m^2] mean
    double power;     ///< [W] reflected
};

std::vector<LitSide> lit_sides(const Scene& scene, const std::vector<Rgb>& radiosity)
{
    std::vector<LitSide> sides;
    for (const bool front : {true, false})
        for (std::uint32_t surface = 0; surface < scene.surfaces().size(); ++surface) {
            if (!front && !scene.two_sided())
                continue;
            const std::uint32_t first = scene.first_patch(surface, front);
            const auto end = first + static_cast<std::uint32_t>(scene.tessellation(surface).cell_count());
            double sum = 0.0;
            for (std::uint32_t i = first; i < end; ++i)
                sum += mean(radiosity[i]);
            const double reflected = std::max(0.0, sum - (end - first) * mean(scene.emittance(first)));
            sides.push_back({first, end, sum / (end - first), scene.area(first) * reflected});
        }
    return sides;
}

/// [W/m^2] The mean radiosity that is reached by the sides that hold nearly all of the reflected power. Not a share of
/// a mean: the spot above a lamp may be a hundred times brighter than the room, and a garden larger. Of sides and not
/// of patches, since few lines leave many patches without light.
double least_lit_radiosity(std::vector<LitSide> sides)
{
    std::sort(sides.begin(), sides.end(), [](const LitSide& a, const LitSide& b) { return a.radiosity < b.radiosity; });
    double all = 0.0;
    for (const LitSide& side : sides)
        all += side.power;
    double passed = 0.0;
    for (const LitSide& side : sides)
        if ((passed += side.power) > in_the_dark * all)
            return side.radiosity;
    return 0.0;
}

/// The patches whose light a picture would show: of bright sides all, of others those that are bright themselves.
std::vector<bool> lit_patches(const Scene& scene, const std::vector<Rgb>& radiosity)
{
    const std::vector<LitSide> sides = lit_sides(scene, radiosity);
    const double least = least_lit_radiosity(sides);
    const auto shows = [least](double light) { return light >= least && light > 0.0; };
    std::vector<bool> is_lit(scene.patch_count());
    for (const LitSide& side : sides)
        for (std::uint32_t i = side.first_patch; i < side.end_patch; ++i)
            is_lit[i] = shows(side.radiosity) || shows(mean(radiosity[i]));
    return is_lit;
}

} // namespace

LitScene::LitScene(const Scene& whole, const std::vector<Rgb>& radiosity)
    : scene(whole), box(whole.bounds()), is_lit(radiosity.empty() ? std::vector<bool>() : lit_patches(whole, radiosity))
{
    if (std::find(is_lit.begin(), is_lit.end(), true) == is_lit.end())
        is_lit.assign(whole.patch_count(), true);
    for (const Surface& surface : scene.surfaces())
        weight += multipath::weight(surface);
}

ViewQuality view_quality(const LitScene& sight, const Camera& camera, double aspect, int rows)
{
    const Scene& scene = sight.scene;
    const int columns = std::max(1, static_cast<int>(std::lround(aspect * rows)));
    const PixelRays rays(camera, columns, rows);
    const Vec3 up = normalized(camera.up);
    VisibleHits visible(scene);
    View view;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            look(sight, rays.through(x + 0.5, y + 0.5), up, visible, view);
    keep_distinct(view.cells);
    keep_distinct(view.surfaces);
    keep_distinct(view.materials);
    double seen = 0.0;
    for (const std::uint32_t surface : view.surfaces)
        seen += weight(scene.surfaces()[surface]);

    const double count = static_cast<double>(columns) * rows;
    const double variety = static_cast<double>(view.cells.size()) / count;
    const double completeness = seen / sight.weight;
    const double balance = 0.5 * share_up_to(view.floor, count, 0.25) + 0.2 * share_up_to(view.ceiling, count, 0.08);
    const double colours =
        0.8 * static_cast<double>(view.materials.size()) / static_cast<double>(scene.materials().size());
    const bool lamp = std::any_of(view.materials.begin(), view.materials.end(), [&](std::uint32_t material) {
        return scene.materials()[material].emittance != Rgb{};
    });
    const double flaws = 0.5 * (view.escaped + view.dark) + 0.15 * view.backs + 2.0 * view.near;
    const double score = variety + completeness + balance + colours + (lamp ? 0.35 : 0.0) - flaws / count;
    return {score, view.escaped / count, view.backs / count, view.dark / count};
}

} // namespace multipath
