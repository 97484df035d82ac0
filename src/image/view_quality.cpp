// A view is judged by a grid of rays, as if by a very small picture.

#include "image/view_quality.h"

#include "base/lists.h"
#include "image/tone_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>

namespace multipath {

namespace {

constexpr double cells_along_diagonal = 24.0; // cells of the scene that are counted to measure variety
constexpr double too_near = 0.08;             // share of the diagonal, for a lit surface
constexpr double in_the_way = 0.1;            // the same for any surface, if much of the picture shows it
constexpr double in_the_dark = 0.02;          // share of the reflected power on sides that count as unlit
constexpr double night = 1e-3;                // of the daylight: even indoors, darker sides count as unlit

/// Statistics of the rays of one view. The members after `dark` are of visible hits of lit fronts only.
struct ViewCounts
{
    int escaped = 0;
    int sky = 0; ///< rays that leave a scene with daylight
    int backs = 0;
    int in_the_way = 0;       ///< hits so near that the surface hides the scene
    std::vector<Rgb> exposed; ///< [W/m^2] radiosity of the hits that do not emit
    int dark = 0;
    int near = 0;
    int floor = 0;   ///< hits of surfaces that face up
    int ceiling = 0; ///< hits of surfaces that face down
    std::set<std::uint64_t> cells;
    std::set<std::uint32_t> surfaces;
    std::set<std::uint32_t> materials;
};

/// Index of the cell that contains a point.
std::uint64_t cell_of(const Bounds& box, Vec3 point)
{
    const double size = box.diagonal() / cells_along_diagonal;
    const Vec3 p = (1.0 / size) * (point - box.low);
    std::uint64_t cell = 0;
    for (const double x : {p.x, p.y, p.z})
        cell = 64 * cell + static_cast<std::uint64_t>(std::clamp(x, 0.0, 63.0));
    return cell;
}

/// Adds a ray to the statistics. `nearest`: its first hit, or null; `seen`: its first visible hit.
void add_ray(const LitScene& lit_scene, const Line& ray, Vec3 up, const Hit* nearest, const std::optional<Hit>& seen,
             ViewCounts& view)
{
    const Scene& scene = lit_scene.scene;
    if (nearest != nullptr && !nearest->front && !scene.is_sky(nearest->surface))
        ++view.backs;
    const Hit* const hit = seen && !scene.is_sky(seen->surface) ? &*seen : nullptr;
    if (hit == nullptr && scene.file().sky_surfaces == 0)
        ++view.escaped;
    if (hit == nullptr) {
        view.sky += has_daylight(scene) ? 1 : 0;
        return;
    }
    if (hit->t < in_the_way * lit_scene.box.diagonal())
        ++view.in_the_way;
    const std::uint32_t patch = scene.patch_at(hit->surface, hit->u, hit->v, hit->front);
    if (!lit_scene.radiosity.empty() && scene.emittance(patch) == Rgb{})
        view.exposed.push_back(lit_scene.radiosity[patch]);
    const bool dark = !lit_scene.is_lit[patch];
    view.dark += dark ? 1 : 0;
    if (!hit->front || dark)
        return;
    if (hit->t < too_near * lit_scene.box.diagonal())
        ++view.near;
    const double upward = dot(scene.surfaces()[hit->surface].normal(), up);
    view.floor += upward > 0.7 ? 1 : 0;
    view.ceiling += upward < -0.7 ? 1 : 0;
    view.materials.insert(scene.file().material[hit->surface]);
    view.cells.insert(cell_of(lit_scene.box, ray.at(hit->t)));
    view.surfaces.insert(hit->surface);
}

/// Sum of the brightness of the pixels: 1 for each that has at least the usual radiosity [W/m^2].
double brightness(const std::vector<Rgb>& pixels, double usual)
{
    return sum_over(pixels, [&](Rgb pixel) { return std::min(1.0, mean(pixel) / usual); });
}

/// Number of pixels that the automatic exposure shows white, or almost black.
int badly_exposed(const std::vector<Rgb>& pixels)
{
    constexpr double almost_black = 0.01; // linear light on the screen
    const double scale = automatic_scale(pixels, ToneOperator::reinhard);
    return static_cast<int>(std::count_if(pixels.begin(), pixels.end(), [scale](Rgb pixel) {
        const double light = mean(screen_light(pixel, ToneOperator::reinhard, scale));
        return light < almost_black || light >= 1.0;
    }));
}

/// Saturating reward: rises like a square root from 0 to 1, which it reaches when the share of the rays is `enough`.
double saturated_share(int count, double rays, double enough)
{
    return std::sqrt(std::min(1.0, count / (rays * enough)));
}

/// Importance of a surface in a picture: the root of its area, so that small objects are not neglected.
double weight(const Surface& surface)
{
    return std::sqrt(surface.area());
}

/// Light of one side of a surface; none on a side without patches and on the sky.
struct LitSide
{
    double radiosity = 0.0; ///< [W/m^2] mean
    double power = 0.0;     ///< [W] reflected
};

/// Index of the side of a surface that a patch belongs to.
std::size_t side_of(const Scene& scene, std::uint32_t patch)
{
    return 2 * std::size_t{scene.surface_of(patch)} + (scene.is_front(patch) ? 0 : 1);
}

std::vector<LitSide> lit_sides(const Scene& scene, const std::vector<Rgb>& radiosity)
{
    std::vector<LitSide> sides(2 * scene.surfaces().size());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        if (scene.is_sky_patch(i))
            continue;
        LitSide& side = sides[side_of(scene, i)];
        const double power = scene.area(i) * mean(radiosity[i]);
        side.radiosity += power / scene.surfaces()[scene.surface_of(i)].area();
        side.power += power - scene.area(i) * mean(scene.emittance(i));
    }
    for (LitSide& side : sides)
        side.power = std::max(0.0, side.power);
    return sides;
}

/// [W/m^2] Threshold of the mean radiosity above which sides count as lit: brighter sides have 98 % of the reflected
/// power. A fraction of the mean would not do, since the spot above a lamp may be a hundred times brighter than the
/// room, and a garden much larger. Sides are compared, not patches, since with few lines many patches receive none.
double lit_threshold(std::vector<LitSide> sides)
{
    std::sort(sides.begin(), sides.end(), [](const LitSide& a, const LitSide& b) { return a.radiosity < b.radiosity; });
    const double all = sum_over(sides, &LitSide::power);
    double passed = 0.0;
    for (const LitSide& side : sides)
        if ((passed += side.power) > in_the_dark * all)
            return side.radiosity;
    return 0.0;
}

/// [W/m^2] Irradiance of a surface in the open.
double daylight(const Scene& scene)
{
    const Rgb sky = scene.file().sky_surfaces > 0 ? scene.surface_material(scene.own_surfaces()).emittance : Rgb{};
    return mean(sky + (scene.file().sun ? scene.file().sun->irradiance : Rgb{}));
}

/// The lit patches: all patches of bright sides, and bright patches of other sides.
std::vector<bool> lit_patches(const Scene& scene, const std::vector<Rgb>& radiosity)
{
    const std::vector<LitSide> sides = lit_sides(scene, radiosity);
    const double least = has_daylight(scene) ? night * daylight(scene) : lit_threshold(sides);
    const auto shows = [least](double light) { return light >= least && light > 0.0; };
    std::vector<bool> is_lit(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        is_lit[i] = !scene.is_sky_patch(i) && (shows(sides[side_of(scene, i)].radiosity) || shows(mean(radiosity[i])));
    return is_lit;
}

} // namespace

bool has_daylight(const Scene& scene)
{
    return scene.file().sky_surfaces > 0 || scene.file().sun;
}

LitScene::LitScene(const Scene& whole, const std::vector<Rgb>& solution)
    : scene(whole),
      radiosity(solution),
      box(whole.own_bounds()),
      is_lit(solution.empty() ? std::vector<bool>() : lit_patches(whole, solution))
{
    if (!is_among(true, is_lit))
        is_lit.assign(whole.patch_count(), true);
    for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s)
        weight += multipath::weight(scene.surfaces()[s]);
    double power = 0.0;
    for (std::uint32_t i = 0; i < radiosity.size(); ++i)
        power += scene.is_sky(scene.surface_of(i)) ? 0.0 : scene.area(i) * mean(radiosity[i]);
    usual_radiosity = power / scene.own_area();
}

ViewQuality view_quality(const LitScene& lit_scene, const Camera& camera, double aspect, int rows)
{
    const Scene& scene = lit_scene.scene;
    constexpr double most_columns = 4096.0; // of extremely wide pictures the middle is judged
    const int columns = std::max(1, static_cast<int>(std::lround(std::min(most_columns, aspect * rows))));
    const PixelRays rays(camera, columns, rows);
    const Vec3 up = normalized(camera.up);
    std::vector<Line> lines;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            lines.push_back(rays.through(x + 0.5, y + 0.5));
    VisibleHits visible(scene);
    const std::vector<std::optional<Hit>>& hits = visible.first(lines);
    ViewCounts view;
    for (std::size_t k = 0; k < lines.size(); ++k)
        add_ray(lit_scene, lines[k], up, visible.nearest().is_hit(k) ? &visible.nearest()[k] : nullptr, hits[k], view);
    const double seen = sum_over(view.surfaces, [&](std::uint32_t s) { return weight(scene.surfaces()[s]); });

    // The weights are empirical.
    const double count = static_cast<double>(columns) * rows;
    const double variety = static_cast<double>(view.cells.size()) / count;
    const double completeness = seen / lit_scene.weight;
    const double balance =
        0.5 * saturated_share(view.floor, count, 0.25) + 0.2 * saturated_share(view.ceiling, count, 0.08);
    const double colours =
        0.8 * static_cast<double>(view.materials.size()) / static_cast<double>(scene.materials().size());
    const bool lamp = std::any_of(view.materials.begin(), view.materials.end(), [&](std::uint32_t material) {
        return scene.materials()[material].emittance != Rgb{};
    });
    const int unexposed = badly_exposed(view.exposed);
    double flaws = 0.5 * (view.escaped + view.dark + unexposed) + 0.15 * view.backs + 2.0 * view.near;
    flaws += 2.0 * std::max(0.0, view.in_the_way - count * ViewQuality::most_in_the_way);
    if (has_daylight(scene)) // then a transparent wall disturbs, and the sunny side is better than the other one
        flaws += 2.0 * view.backs + std::max(0.0, view.sky - 0.6 * count) -
                 brightness(view.exposed, lit_scene.usual_radiosity);
    const double score = variety + completeness + balance + colours + (lamp ? 0.35 : 0.0) - flaws / count;
    return {
        score, view.escaped / count, view.backs / count, view.dark / count, unexposed / count, view.in_the_way / count};
}

} // namespace multipath
