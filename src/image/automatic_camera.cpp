// The camera is found by search. The candidates are positions where a photographer might stand: along the walls and in
// the corners at several heights, outside each wall (whose back is transparent), and in front of each side of the
// scene. A coarse grid of rays scores each candidate, a finer grid the best ones. If the scene can be seen from outside
// without looking through a wall, only those candidates compete. At first all surfaces count as lit. If the best view
// is not good in the light of the solution, because unlit or badly exposed surfaces fill it, rooms are searched for
// around the lit surfaces: a house with lamps inside is not shown from the garden, nor a flat with its dark rooms.
//
// In daylight the outside is lit, too. Then a view of a room or courtyard is preferred. If there is none that is good,
// the candidates are outdoors, as near as everything that rises above the ground fits into the picture.

#include "image/automatic_camera.h"

#include "base/elementary.h"
#include "base/errors.h"
#include "geometry/bounds.h"
#include "geometry/polygon.h"
#include "image/view_quality.h"
#include "sampling/discrete_distribution.h"
#include "sampling/warp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace multipath {

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
    Vec3 centre() const { return at(0.5, 0.5, 0.5); }
    /// The coordinates of a point in these axes.
    Vec3 place_of(Vec3 point) const { return {dot(point, axis_x), dot(point, axis_y), dot(point, axis_z)}; }
    bool contains(Vec3 point) const { return overlap(box, {place_of(point), place_of(point)}); }
    std::array<Vec3, 8> corners() const
    {
        return {at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), at(1, 1, 0), at(0, 0, 1), at(1, 0, 1), at(0, 1, 1), at(1, 1, 1)};
    }
    /// The bounding box of a surface in these axes.
    Bounds box_of(const Surface& surface) const
    {
        Bounds result;
        for (const Vec3 corner : corners_of(surface))
            result.include(place_of(corner));
        return result;
    }
};

/// Makes every side at least a tenth of the diagonal, so that there is space for a camera around a flat scene.
void grow_if_flat(Bounds& box)
{
    const double half = 0.05 * box.diagonal();
    const Vec3 centre = box.centre();
    box.include(centre - Vec3{half, half, half});
    box.include(centre + Vec3{half, half, half});
}

/// The box, in the axes of a room, of all surfaces that rise above a height in these axes.
Bounds box_above(const Scene& scene, const Room& axes, double height)
{
    Bounds result;
    for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s)
        if (const Bounds box = axes.box_of(scene.surfaces()[s]); box.high.y > height)
            result.include(box);
    return result;
}

Room room_of(const Scene& scene, Vec3 up)
{
    Room room;
    room.axis_y = normalized(up);
    const Vec3 toward = std::abs(room.axis_y.z) < 0.9 ? Vec3{0.0, 0.0, 1.0} : Vec3{0.0, -1.0, 0.0};
    room.axis_x = normalized(cross(room.axis_y, toward));
    room.axis_z = cross(room.axis_x, room.axis_y);
    room.box = box_above(scene, room, -Bounds::infinity);
    grow_if_flat(room.box);
    return room;
}

/// The part of a scene that rises above its ground; the whole scene if nothing does.
Room above_ground(const Scene& scene, const Room& whole)
{
    const Bounds all = box_above(scene, whole, -Bounds::infinity);
    Room room = whole;
    room.box = box_above(scene, whole, all.low.y + 0.05 * all.size().y);
    if (room.box.empty())
        return whole;
    grow_if_flat(room.box);
    return room;
}

/// The distance along each ray to the first surface; nothing where a ray leaves the scene or meets a transparent back.
std::vector<std::optional<double>> free_paths(const Scene& scene, const std::vector<Line>& rays)
{
    VisibleHits visible(scene);
    const std::vector<std::optional<Hit>>& hits = visible.first(rays);
    std::vector<std::optional<double>> paths(rays.size());
    for (std::size_t k = 0; k < rays.size(); ++k)
        if (hits[k] && !scene.is_sky(hits[k]->surface) && hits[k]->t == visible.nearest()[k].t)
            paths[k] = hits[k]->t;
    return paths;
}

/// The distance from a point to the wall ahead. Where this ray leaves the scene, as through a window, it is that to the
/// farthest part of the wall that slanted rays meet. Nothing if there is none.
std::optional<double> distance_to_wall(const Scene& scene, Vec3 from, Vec3 ahead, Vec3 aside, Vec3 upwards)
{
    std::vector<Line> rays = {{from, ahead}};
    for (const double u : {-0.6, 0.6})
        for (const double v : {-0.6, 0.6})
            rays.push_back({from, normalized(ahead + u * aside + v * upwards)});
    const std::vector<std::optional<double>> paths = free_paths(scene, rays);
    std::optional<double> distance = paths[0];
    for (std::size_t k = 1; k < rays.size() && !paths[0]; ++k)
        if (paths[k])
            distance = std::max(distance.value_or(0.0), *paths[k] * dot(rays[k].direction, ahead));
    return distance;
}

/// The room around a point in free space: a box that extends along each axis to the first surface, as seen from the
/// point and then once more from the middle of that box. Only walls have windows. In daylight a court without a
/// ceiling, with windowless walls as high as the scene, is a room, too. Nothing if a side is missing.
std::optional<Room> room_around(const Scene& scene, const Room& whole, Vec3 point)
{
    Room room = whole;
    for (int pass = 0; pass < 2; ++pass) {
        const Vec3 place = whole.place_of(point);
        const auto path = [&](Vec3 ahead) { return free_paths(scene, {{point, ahead}})[0]; };
        const std::optional<double> down = path(-whole.axis_y);
        std::optional<double> to_ceiling = path(whole.axis_y);
        const bool is_court = !to_ceiling && has_daylight(scene);
        if (is_court)
            to_ceiling = whole.box.high.y - place.y;
        Bounds box;
        for (const double sign : {1.0, -1.0}) {
            const auto to_wall = [&](Vec3 ahead, Vec3 aside) {
                return is_court ? path(ahead) : distance_to_wall(scene, point, ahead, aside, whole.axis_y);
            };
            const std::optional<double> to_x = to_wall(sign * whole.axis_x, whole.axis_z);
            const std::optional<double> to_y = sign > 0.0 ? to_ceiling : down;
            const std::optional<double> to_z = to_wall(sign * whole.axis_z, whole.axis_x);
            if (!to_x || !to_y || !to_z)
                return std::nullopt;
            box.include(place + sign * Vec3{*to_x, *to_y, *to_z});
        }
        room.box = box;
        point = room.centre();
    }
    grow_if_flat(room.box);
    return room;
}

/// A room with light.
struct LitRoom
{
    Room room;
    int points = 0; ///< number of points in it above lit patches
};

/// Rooms with light, at most three. Those around points above patches that are chosen in proportion to their reflected
/// power, or in daylight, which is nearly all outside, to their area. The rooms with most such points come first.
std::vector<LitRoom> lit_rooms(const LitScene& lit_scene, const Room& whole)
{
    constexpr int points = 64;
    constexpr std::size_t most_rooms = 3;
    const Scene& scene = lit_scene.scene;
    const bool by_area = has_daylight(scene) || lit_scene.radiosity.empty();
    DiscreteDistribution light;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double share = by_area ? 1.0 : std::max(0.0, mean(lit_scene.radiosity[i] - scene.emittance(i)));
        light.add(lit_scene.is_lit[i] && !scene.is_sky_patch(i) ? share * scene.area(i) : 0.0);
    }
    std::vector<LitRoom> found;
    for (int k = 0; k < points && light.total() > 0.0; ++k) {
        const Patch patch = scene.patch(static_cast<std::uint32_t>(light.at((k + 0.5) / points)));
        const Line away = {patch.shape.centre(), patch.shape.normal()};
        const std::optional<Hit> opposite = scene.intersector().closest_hit_from(patch.surface, away);
        const bool is_open = !opposite || scene.is_sky(opposite->surface);
        const Vec3 middle = away.at(0.5 * (is_open ? 0.1 * whole.box.diagonal() : opposite->t));
        const auto known =
            std::find_if(found.begin(), found.end(), [&](const LitRoom& lit) { return lit.room.contains(middle); });
        if (known != found.end())
            ++known->points;
        else if (const std::optional<Room> room = room_around(scene, whole, middle))
            found.push_back({*room, 1});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const LitRoom& a, const LitRoom& b) { return a.points > b.points; });
    found.resize(std::min(most_rooms, found.size()));
    return found;
}

/// [degrees] Vertical field of view, reduced in wide pictures so that the horizontal one is at most `widest`: otherwise
/// their sides would look stretched.
double field_of_view(double vertical, double widest, double aspect)
{
    const double from_width =
        2.0 / radians_per_degree * elementary::atan(elementary::tan(0.5 * widest * radians_per_degree) / aspect);
    return std::min(vertical, from_width);
}

/// Cameras along the walls and in the corners that look across the room.
std::vector<Camera> inside_cameras(const Room& room, Vec3 up, double aspect)
{
    constexpr double inset = 0.05;
    constexpr double steepest = 0.7; // in high rooms the cameras would look down too steeply
    constexpr double places[] = {inset, 0.3, 0.5, 0.7, 1.0 - inset};
    const auto at_wall = [&](double place) { return place == inset || place == 1.0 - inset; };
    std::vector<Camera> cameras;
    for (const double vertical : {58.0, 68.0})
        for (const double x : places)
            for (const double z : places) {
                if (!at_wall(x) && !at_wall(z))
                    continue;
                const auto target = [&](double height) {
                    return room.at(0.5 + 0.4 * (0.5 - x), height, 0.5 + 0.4 * (0.5 - z));
                };
                for (const double eye_height : {0.55, 0.65, 0.75})
                    for (const double target_height : {0.35, 0.45}) {
                        const Vec3 eye = room.at(x, eye_height, z);
                        const double least =
                            eye_height - steepest * length(target(eye_height) - eye) / room.box.size().y;
                        cameras.push_back({eye, target(std::max(least, target_height)), up,
                                           field_of_view(vertical, vertical + 20.0, aspect)});
                    }
            }
    return cameras;
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

/// [scene units] The distance from the centre of a room at which a camera in this direction sees all of its box.
double fitting_distance(const Room& room, Vec3 direction, double angle, double aspect)
{
    const double half_height = elementary::tan(0.5 * angle * radians_per_degree);
    const Vec3 right = normalized(cross(room.axis_y, direction));
    const Vec3 above = cross(direction, right);
    double distance = 0.0;
    for (const Vec3 point : room.corners()) {
        const Vec3 corner = point - room.centre();
        const double aside = std::max(std::abs(dot(corner, above)), std::abs(dot(corner, right)) / aspect);
        distance = std::max(distance, aside / half_height + dot(corner, direction));
    }
    return distance;
}

/// Cameras in these directions from the centre of a room, `margin` times as far away as all of it fits into the
/// picture.
std::vector<Camera> cameras_around(const Room& room, const std::vector<Vec3>& directions, double margin, Vec3 up,
                                   double aspect)
{
    const double angle = field_of_view(45.0, 60.0, aspect);
    std::vector<Camera> cameras;
    for (const Vec3 direction : directions) {
        const double distance = margin * fitting_distance(room, direction, angle, aspect);
        cameras.push_back({room.centre() + distance * direction, room.centre(), up, angle});
    }
    return cameras;
}

/// Cameras in front of each side and above each corner.
std::vector<Camera> outside_cameras(const Room& room, Vec3 up, double aspect)
{
    std::vector<Vec3> directions;
    for (const double side : {1.0, -1.0}) {
        directions.push_back(side * room.axis_z);
        directions.push_back(side * room.axis_x);
        for (const double other_side : {1.0, -1.0})
            directions.push_back(normalized(side * room.axis_x + 0.6 * room.axis_y + other_side * room.axis_z));
    }
    return cameras_around(room, directions, 1.0, up, aspect);
}

/// A candidate and the quality of its view.
struct RatedCamera
{
    Camera camera;
    ViewQuality quality;
};

/// The `count` cameras with the highest scores, best first; of equal ones the earlier.
std::vector<RatedCamera> best_cameras(const LitScene& lit_scene, const std::vector<Camera>& cameras, double aspect,
                                      int rows, std::size_t count)
{
    std::vector<RatedCamera> rated;
    for (const Camera& camera : cameras)
        rated.push_back({camera, view_quality(lit_scene, camera, aspect, rows)});
    std::stable_sort(rated.begin(), rated.end(),
                     [](const RatedCamera& a, const RatedCamera& b) { return a.quality.score > b.quality.score; });
    rated.resize(std::min(count, rated.size()));
    return rated;
}

/// The best of the candidates, found in two steps.
std::optional<RatedCamera> best_of(const LitScene& lit_scene, const std::vector<Camera>& cameras, double aspect)
{
    std::vector<Camera> finalists;
    for (const RatedCamera& rated : best_cameras(lit_scene, cameras, aspect, coarse_rows, 8))
        finalists.push_back(rated.camera);
    const std::vector<RatedCamera> best = best_cameras(lit_scene, finalists, aspect, fine_rows, 1);
    return best.empty() ? std::nullopt : std::optional(best.front());
}

/// The best of all candidates in and around a room. A camera in front of an open side or of an object, which looks
/// through hardly any backs and whose picture is filled well, is preferred.
Camera best_camera(const LitScene& lit_scene, const Room& room, double aspect, Vec3 up)
{
    constexpr double most_backs = 0.01;
    std::vector<Camera> cameras = outside_cameras(room, up, aspect);
    for (const auto& [camera, quality] : best_cameras(lit_scene, cameras, aspect, fine_rows, cameras.size()))
        if (quality.back_share < most_backs && quality.escaped_share + quality.dark_share < 0.6)
            return camera;
    const std::vector<Camera> inside = inside_cameras(room, up, aspect);
    cameras.insert(cameras.end(), inside.begin(), inside.end());
    append_behind_walls(room, up, field_of_view(54.0, 74.0, aspect), cameras);
    return best_of(lit_scene, cameras, aspect)->camera;
}

/// True if a camera is surrounded by walls: at least 14 of 16 level rays end at a visible surface.
bool is_surrounded(const Scene& scene, const Room& axes, Vec3 eye)
{
    std::vector<Line> rays;
    for (int k = 0; k < 16; ++k) {
        const SinCos turn = sin_cos_of_turns((k + 0.5) / 16.0);
        rays.push_back({eye, turn.cos * axes.axis_x + turn.sin * axes.axis_z});
    }
    const std::vector<std::optional<double>> paths = free_paths(scene, rays);
    return std::count(paths.begin(), paths.end(), std::nullopt) <= 2;
}

/// The best of the cameras in rooms. Nothing if none is good.
std::optional<RatedCamera> best_indoor_camera(LitScene lit_scene, const Room& whole, double aspect, Vec3 up)
{
    std::optional<RatedCamera> best;
    for (const LitRoom& lit : lit_rooms(lit_scene, whole)) {
        std::vector<Camera> cameras = inside_cameras(lit.room, up, aspect);
        cameras.erase(std::remove_if(cameras.begin(), cameras.end(),
                                     [&](const Camera& c) { return !is_surrounded(lit_scene.scene, whole, c.eye); }),
                      cameras.end());
        lit_scene.box = {};
        for (const Vec3 corner : lit.room.corners())
            lit_scene.box.include(corner);
        const std::optional<RatedCamera> found = best_of(lit_scene, cameras, aspect);
        if (found && found->quality.is_good() && (!best || found->quality.score > best->quality.score))
            best = found;
    }
    return best;
}

/// The best of the cameras outdoors, around what rises above the ground.
Camera best_outdoor_camera(const LitScene& lit_scene, const Room& whole, double aspect, Vec3 up)
{
    const Room room = above_ground(lit_scene.scene, whole);
    std::vector<Vec3> directions;
    for (int k = 0; k < 8; ++k) {
        const SinCos turn = sin_cos_of_turns((k + 0.5) / 8.0);
        for (const double rise : {0.1, 0.4})
            directions.push_back(normalized(turn.cos * room.axis_x + turn.sin * room.axis_z + rise * room.axis_y));
    }
    return best_cameras(lit_scene, cameras_around(room, directions, 1.1, up, aspect), aspect, fine_rows, 1)
        .front()
        .camera;
}

} // namespace

Camera automatic_camera(const Scene& scene, double aspect, Vec3 up, const std::vector<Rgb>& radiosity)
{
    if (!(length(up) > 0.0) || !std::isfinite(length(up)))
        throw SettingsError("camera: the up direction must be a finite vector that is not zero");
    const Room room = room_of(scene, up);
    const LitScene lit_scene(scene, radiosity);
    if (has_daylight(scene)) {
        const std::optional<RatedCamera> indoors = best_indoor_camera(lit_scene, room, aspect, up);
        return indoors ? indoors->camera : best_outdoor_camera(lit_scene, room, aspect, up);
    }
    // The solution is used only if necessary, so that a good view does not depend on its noise.
    const Camera plain = best_camera(LitScene(scene), room, aspect, up);
    if (view_quality(lit_scene, plain, aspect, fine_rows).is_good())
        return plain;
    const std::optional<RatedCamera> indoors = best_indoor_camera(lit_scene, room, aspect, up);
    return indoors ? indoors->camera : best_camera(lit_scene, room, aspect, up);
}

} // namespace multipath
