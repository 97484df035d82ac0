// The camera is found by search. The candidates are positions where a photographer might stand: along the walls and in
// the corners at several heights, outside each wall (whose back is transparent), and in front of each side of the
// scene. A coarse grid of rays scores each candidate, a finer grid the best ones. If the scene can be seen from outside
// without looking through a wall, only those candidates compete. At first all surfaces count as lit. If the best view
// shows many unlit surfaces, the search is repeated with unlit surfaces counted as unseen: a house with lamps inside is
// not shown from the garden. This may fail for a small house in a large garden. Then the search is restricted to the
// part of the scene that contains the light.

#include "image/automatic_camera.h"

#include "geometry/bounds.h"
#include "geometry/elementary.h"
#include "geometry/polygon.h"
#include "scene/input_error.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace multipath {

namespace {

constexpr double cells_along_diagonal = 24.0; // cells of the scene that are counted to measure variety
constexpr double too_near = 0.08;             // share of the scene's diagonal
constexpr double in_the_dark = 0.02;          // share of the reflected power on sides that count as unlit

/// Statistics of the rays of one view. The members after `dark` are of visible hits of lit fronts only.
struct ViewCounts
{
    int escaped = 0;
    int backs = 0;
    int dark = 0;
    int near = 0;
    int floor = 0;   ///< hits of surfaces that face up
    int ceiling = 0; ///< hits of surfaces that face down
    std::vector<std::uint64_t> cells;
    std::vector<std::uint32_t> surfaces;
    std::vector<std::uint32_t> materials;
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
    const bool dark = hit != nullptr && !lit_scene.is_lit[scene.patch_at(hit->surface, hit->u, hit->v, hit->front)];
    view.dark += dark ? 1 : 0;
    if (hit == nullptr || !hit->front || dark)
        return;
    if (hit->t < too_near * lit_scene.box.diagonal())
        ++view.near;
    const double upward = dot(scene.surfaces()[hit->surface].normal(), up);
    view.floor += upward > 0.7 ? 1 : 0;
    view.ceiling += upward < -0.7 ? 1 : 0;
    view.materials.push_back(scene.file().material[hit->surface]);
    view.cells.push_back(cell_of(lit_scene.box, ray.at(hit->t)));
    view.surfaces.push_back(hit->surface);
}

template <class T>
void keep_distinct(std::vector<T>& items)
{
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
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

/// Light of one side of a surface.
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
            if ((!front && !scene.two_sided()) || scene.is_sky(surface))
                continue;
            const std::uint32_t first = scene.first_patch(surface, front);
            const auto end = first + static_cast<std::uint32_t>(scene.tessellation(surface).cell_count());
            const double area = scene.surfaces()[surface].area();
            double power = 0.0;
            for (std::uint32_t i = first; i < end; ++i)
                power += scene.area(i) * mean(radiosity[i]);
            sides.push_back({first, end, power / area, std::max(0.0, power - area * mean(scene.emittance(first)))});
        }
    return sides;
}

/// [W/m^2] Threshold of the mean radiosity above which sides count as lit: brighter sides have 98 % of the reflected
/// power. A fraction of the mean would not do, since the spot above a lamp may be a hundred times brighter than the
/// room, and a garden much larger. Sides are compared, not patches, since with few lines many patches receive none.
double lit_threshold(std::vector<LitSide> sides)
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

/// The lit patches: all patches of bright sides, and bright patches of other sides.
std::vector<bool> lit_patches(const Scene& scene, const std::vector<Rgb>& radiosity)
{
    const std::vector<LitSide> sides = lit_sides(scene, radiosity);
    const double least = lit_threshold(sides);
    const auto shows = [least](double light) { return light >= least && light > 0.0; };
    std::vector<bool> is_lit(scene.patch_count());
    for (const LitSide& side : sides)
        for (std::uint32_t i = side.first_patch; i < side.end_patch; ++i)
            is_lit[i] = shows(side.radiosity) || shows(mean(radiosity[i]));
    return is_lit;
}

} // namespace

LitScene::LitScene(const Scene& whole, const std::vector<Rgb>& radiosity)
    : scene(whole),
      box(whole.own_bounds()),
      is_lit(radiosity.empty() ? std::vector<bool>() : lit_patches(whole, radiosity))
{
    if (std::find(is_lit.begin(), is_lit.end(), true) == is_lit.end())
        is_lit.assign(whole.patch_count(), true);
    for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s)
        weight += multipath::weight(scene.surfaces()[s]);
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
    keep_distinct(view.cells);
    keep_distinct(view.surfaces);
    keep_distinct(view.materials);
    double seen = 0.0;
    for (const std::uint32_t surface : view.surfaces)
        seen += weight(scene.surfaces()[surface]);

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
    const double flaws = 0.5 * (view.escaped + view.dark) + 0.15 * view.backs + 2.0 * view.near;
    const double score = variety + completeness + balance + colours + (lamp ? 0.35 : 0.0) - flaws / count;
    return {score, view.escaped / count, view.backs / count, view.dark / count};
}

namespace {

constexpr int coarse_rows = 9;
constexpr int fine_rows = 18;

/// A box around the scene with `up` as its second axis, so that rooms of any orientation are treated alike.
struct Room
{
    Vec3 axis_x, axis_y, axis_z; ///< unit vectors, y up
    Bounds box;                  ///< in these axes

    /// The point at these fractions of width, height and depth.
    Vec3 at(double x, double y, double z) const
    {
        const Vec3 size = box.size();
        return (box.low.x + x * size.x) * axis_x + (box.low.y + y * size.y) * axis_y +
               (box.low.z + z * size.z) * axis_z;
    }
    /// Axis-aligned bounding box of the room.
    Bounds in_space() const
    {
        Bounds result;
        for (const double x : {0.0, 1.0})
            for (const double y : {0.0, 1.0})
                for (const double z : {0.0, 1.0})
                    result.include(at(x, y, z));
        return result;
    }
};

/// Makes every side at least a tenth of the diagonal, so that there is space for a camera around a flat scene.
void grow_if_flat(Bounds& box)
{
    const double least = 0.1 * box.diagonal();
    const Vec3 size = box.size();
    const Vec3 missing = {std::max(0.0, least - size.x), std::max(0.0, least - size.y), std::max(0.0, least - size.z)};
    box.low = box.low - 0.5 * missing;
    box.high = box.high + 0.5 * missing;
}

Room room_of(const Scene& scene, Vec3 up)
{
    Room room;
    room.axis_y = normalized(up);
    const Vec3 toward = std::abs(room.axis_y.z) < 0.9 ? Vec3{0.0, 0.0, 1.0} : Vec3{0.0, -1.0, 0.0};
    room.axis_x = normalized(cross(room.axis_y, toward));
    room.axis_z = cross(room.axis_x, room.axis_y);
    for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s)
        for (const Vec3 corner : corners_of(scene.surfaces()[s]))
            room.box.include(Vec3{dot(corner, room.axis_x), dot(corner, room.axis_y), dot(corner, room.axis_z)});
    grow_if_flat(room.box);
    return room;
}

/// Box around the reflected power, or around the emitted power if there is no other. Along each axis 2 % of the power
/// is left out at either end, such as light that leaves the room through windows.
Room lit_room(const Scene& scene, const std::vector<Rgb>& radiosity, Vec3 up)
{
    constexpr double left_out = 0.02; // share of the power at either end
    std::vector<double> power;        // [W] per patch
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        power.push_back(scene.area(i) * std::max(0.0, mean(radiosity[i] - scene.emittance(i))));
    if (std::all_of(power.begin(), power.end(), [](double p) { return p == 0.0; }))
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            power[i] = scene.is_sky(scene.surface_of(i)) ? 0.0 : scene.area(i) * mean(radiosity[i]);
    const double all = std::accumulate(power.begin(), power.end(), 0.0);

    const auto range_along = [&](Vec3 axis) {
        std::vector<std::pair<double, double>> positions; // along the axis, with the power [W] of the patch there
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            if (power[i] > 0.0)
                positions.emplace_back(dot(scene.patch(i).shape.centre(), axis), power[i]);
        if (positions.empty()) // no light anywhere
            return std::pair<double, double>{0.0, 0.0};
        std::sort(positions.begin(), positions.end());
        std::pair<double, double> range{positions.front().first, positions.back().first};
        double passed = 0.0;
        for (const auto& [position, light] : positions) {
            if (passed <= left_out * all)
                range.first = position;
            if (passed <= (1.0 - left_out) * all)
                range.second = position;
            passed += light;
        }
        return range;
    };
    Room room = room_of(scene, up);
    std::tie(room.box.low.x, room.box.high.x) = range_along(room.axis_x);
    std::tie(room.box.low.y, room.box.high.y) = range_along(room.axis_y);
    std::tie(room.box.low.z, room.box.high.z) = range_along(room.axis_z);
    grow_if_flat(room.box);
    return room;
}

/// [degrees] Vertical field of view, reduced in wide pictures so that the horizontal one is at most `widest`: otherwise
/// their sides would look stretched.
double field_of_view(double vertical, double widest, double aspect)
{
    const double from_width =
        2.0 / radians_per_degree * elementary::atan(elementary::tan(0.5 * widest * radians_per_degree) / aspect);
    return std::min(vertical, from_width);
}

/// Appends cameras along the walls and in the corners that look across the room.
void append_inside(const Room& room, Vec3 up, double angle, std::vector<Camera>& cameras)
{
    constexpr double inset = 0.05;
    constexpr double places[] = {inset, 0.3, 0.5, 0.7, 1.0 - inset};
    for (const double x : places)
        for (const double z : places) {
            const bool at_wall = x == inset || z == inset || x == 1.0 - inset || z == 1.0 - inset;
            if (!at_wall)
                continue;
            for (const double eye_height : {0.55, 0.65, 0.75})
                for (const double target_height : {0.35, 0.45})
                    cameras.push_back({room.at(x, eye_height, z),
                                       room.at(0.5 + 0.4 * (0.5 - x), target_height, 0.5 + 0.4 * (0.5 - z)), up,
                                       angle});
        }
}

/// Appends cameras outside each wall that look through its back, for rooms that are too small to step back in.
void append_behind_walls(const Room& room, Vec3 up, double angle, std::vector<Camera>& cameras)
{
    for (const double outside : {-0.35, -0.5, -0.65})
        for (const double eye_height : {0.55, 0.65})
            for (const double position : {outside, 1.0 - outside}) {
                cameras.push_back({room.at(position, eye_height, 0.5), room.at(0.5, 0.45, 0.5), up, angle});
                cameras.push_back({room.at(0.5, eye_height, position), room.at(0.5, 0.45, 0.5), up, angle});
            }
}

/// Cameras in front of each side, far enough away to see all of it, and above each corner.
std::vector<Camera> outside_cameras(const Room& room, Vec3 up, double angle, double aspect)
{
    std::vector<Camera> cameras;
    const Vec3 size = room.box.size();
    const double half_height = elementary::tan(0.5 * angle * radians_per_degree);
    const double diagonal_distance = 0.5 * room.box.diagonal() / elementary::sin(0.5 * angle * radians_per_degree);
    for (const double side : {1.0, -1.0}) {
        const double for_height = 0.5 * size.y / half_height;
        const double along_z = std::max(for_height, 0.5 * size.x / (half_height * aspect)) / size.z + 0.5;
        const double along_x = std::max(for_height, 0.5 * size.z / (half_height * aspect)) / size.x + 0.5;
        cameras.push_back({room.at(0.5, 0.5, 0.5 + side * along_z), room.at(0.5, 0.5, 0.5), up, angle});
        cameras.push_back({room.at(0.5 + side * along_x, 0.5, 0.5), room.at(0.5, 0.5, 0.5), up, angle});
        for (const double other_side : {1.0, -1.0}) {
            const Vec3 slant = normalized(side * room.axis_x + 0.6 * room.axis_y + other_side * room.axis_z);
            const Vec3 centre = room.at(0.5, 0.5, 0.5);
            cameras.push_back({centre + diagonal_distance * slant, centre, up, angle});
        }
    }
    return cameras;
}

/// The `count` cameras with the highest scores, best first; of equal ones the earlier.
std::vector<Camera> best_cameras(const LitScene& lit_scene, const std::vector<Camera>& cameras, double aspect, int rows,
                                 std::size_t count)
{
    std::vector<std::pair<double, std::size_t>> ranking; // negative score, index
    for (std::size_t i = 0; i < cameras.size(); ++i)
        ranking.emplace_back(-view_quality(lit_scene, cameras[i], aspect, rows).score, i);
    std::sort(ranking.begin(), ranking.end());
    std::vector<Camera> best;
    for (std::size_t i = 0; i < std::min(count, ranking.size()); ++i)
        best.push_back(cameras[ranking[i].second]);
    return best;
}

/// The cameras in `outside` that look through hardly any backs and whose picture is filled well: those in front of an
/// open side, or of an object.
std::vector<Camera> unobstructed(const LitScene& lit_scene, const std::vector<Camera>& outside, double aspect)
{
    // Under a sky the outside is lit, so that more backs are acceptable.
    const double most_backs = lit_scene.scene.file().sky_surfaces > 0 ? 0.15 : 0.01;
    std::vector<Camera> result;
    for (const Camera& camera : outside) {
        const ViewQuality quality = view_quality(lit_scene, camera, aspect, fine_rows);
        if (quality.back_share < most_backs && quality.escaped_share + quality.dark_share < 0.6)
            result.push_back(camera);
    }
    return result;
}

/// The best of all candidates in and around a room.
Camera best_camera(const LitScene& lit_scene, const Room& room, double aspect, Vec3 up)
{
    const std::vector<Camera> outside = outside_cameras(room, up, field_of_view(45.0, 60.0, aspect), aspect);
    const std::vector<Camera> open = unobstructed(lit_scene, outside, aspect);
    if (!open.empty())
        return best_cameras(lit_scene, open, aspect, fine_rows, 1).front();

    std::vector<Camera> cameras = outside;
    for (const double vertical : {58.0, 68.0})
        append_inside(room, up, field_of_view(vertical, vertical + 20.0, aspect), cameras);
    append_behind_walls(room, up, field_of_view(54.0, 74.0, aspect), cameras);
    const std::vector<Camera> shortlist = best_cameras(lit_scene, cameras, aspect, coarse_rows, 8);
    return best_cameras(lit_scene, shortlist, aspect, fine_rows, 1).front();
}

} // namespace

Camera automatic_camera(const Scene& scene, double aspect, Vec3 up, const std::vector<Rgb>& radiosity)
{
    if (!(length(up) > 0.0) || !std::isfinite(length(up)))
        throw SettingsError("camera: the up direction must be a finite vector that is not zero");
    // The solution is used only if necessary, so that a good view does not depend on its noise.
    const Room room = room_of(scene, up);
    const Camera plain = best_camera(LitScene(scene), room, aspect, up);
    LitScene lit_scene(scene, radiosity);
    if (view_quality(lit_scene, plain, aspect, fine_rows).is_lit())
        return plain;
    const Camera camera = best_camera(lit_scene, room, aspect, up);
    const ViewQuality quality = view_quality(lit_scene, camera, aspect, fine_rows);
    if (quality.is_lit() || radiosity.empty())
        return camera;

    const Room lit = lit_room(scene, radiosity, up);
    lit_scene.box = lit.in_space();
    const Camera closer = best_camera(lit_scene, lit, aspect, up);
    return view_quality(lit_scene, closer, aspect, fine_rows).dark_share < quality.dark_share ? closer : camera;
}

} // namespace multipath
