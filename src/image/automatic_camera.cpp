// Many places where a photographer might stand are tried: along the walls and in the corners at several heights, behind
// each wall, and outside in front of each side. A coarse grid of rays tells what each would see, a finer one decides
// among the best. A scene that can be seen from outside without looking through anything is seen from there.

#include "image/automatic_camera.h"

#include "geometry/bounds.h"
#include "geometry/flat_polygon.h"
#include "image/view_quality.h"
#include "scene/input_error.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace multipath {

namespace {

constexpr int coarse_rows = 9;
constexpr int fine_rows = 18;

/// The scene's box with `up` as its second axis, so that rooms of any orientation are treated alike.
struct Room
{
    Vec3 axis_x, axis_y, axis_z; ///< unit vectors, y up
    Bounds box;                  ///< in these axes

    /// The point at fractions of width, height and depth.
    Vec3 at(double x, double y, double z) const
    {
        const Vec3 size = box.size();
        return (box.low.x + x * size.x) * axis_x + (box.low.y + y * size.y) * axis_y +
               (box.low.z + z * size.z) * axis_z;
    }
};

Room room_of(const Scene& scene, Vec3 up)
{
    Room room;
    room.axis_y = normalized(up);
    const Vec3 toward = std::abs(room.axis_y.z) < 0.9 ? Vec3{0.0, 0.0, 1.0} : Vec3{0.0, -1.0, 0.0};
    room.axis_x = normalized(cross(room.axis_y, toward));
    room.axis_z = cross(room.axis_x, room.axis_y);
    for (const Surface& surface : scene.surfaces())
        for (const Vec3 corner : corners_of(surface))
            room.box.include(Vec3{dot(corner, room.axis_x), dot(corner, room.axis_y), dot(corner, room.axis_z)});
    // A flat scene still needs a room around it to stand in.
    const double least = 0.1 * room.box.diagonal();
    const Vec3 size = room.box.size();
    const Vec3 missing = {std::max(0.0, least - size.x), std::max(0.0, least - size.y), std::max(0.0, least - size.z)};
    room.box.low = room.box.low - 0.5 * missing;
    room.box.high = room.box.high + 0.5 * missing;
    return room;
}

/// The vertical angle [degrees], smaller in wide pictures so that their sides are not stretched.
double field_of_view(double vertical, double widest, double aspect)
{
    const double from_width =
        2.0 / radians_per_degree * std::atan(std::tan(0.5 * widest * radians_per_degree) / aspect);
    return std::min(vertical, from_width);
}

/// Eyes along the walls and in the corners, each looking across the room.
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

/// Eyes behind a wall that is looked through, where a room is too small to step back in.
void append_behind_walls(const Room& room, Vec3 up, double angle, std::vector<Camera>& cameras)
{
    for (const double outside : {-0.35, -0.5, -0.65})
        for (const double eye_height : {0.55, 0.65})
            for (const double place : {outside, 1.0 - outside}) {
                cameras.push_back({room.at(place, eye_height, 0.5), room.at(0.5, 0.45, 0.5), up, angle});
                cameras.push_back({room.at(0.5, eye_height, place), room.at(0.5, 0.45, 0.5), up, angle});
            }
}

/// Eyes in front of each side, far enough to see all of its opening, and above each corner.
std::vector<Camera> outside_cameras(const Room& room, Vec3 up, double angle, double aspect)
{
    std::vector<Camera> cameras;
    const Vec3 size = room.box.size();
    const double half_height = std::tan(0.5 * angle * radians_per_degree);
    const double diagonal_distance = 0.5 * room.box.diagonal() / std::sin(0.5 * angle * radians_per_degree);
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

/// The `count` best of the cameras, the best first; of equals the earlier.
std::vector<Camera> best_cameras(const Scene& scene, const std::vector<Camera>& cameras, double aspect, int rows,
                                 std::size_t count)
{
    std::vector<std::pair<double, std::size_t>> ranking; // penalty, number
    for (std::size_t i = 0; i < cameras.size(); ++i)
        ranking.emplace_back(-view_quality(scene, cameras[i], aspect, rows).score, i);
    std::sort(ranking.begin(), ranking.end());
    std::vector<Camera> best;
    for (std::size_t i = 0; i < std::min(count, ranking.size()); ++i)
        best.push_back(cameras[ranking[i].second]);
    return best;
}

/// Of cameras outside, those that look through no back and fill much of their picture: an open side, or an object, is
/// meant to be seen from there.
std::vector<Camera> unobstructed(const Scene& scene, const std::vector<Camera>& outside, double aspect)
{
    std::vector<Camera> result;
    for (const Camera& camera : outside) {
        const ViewQuality quality = view_quality(scene, camera, aspect, fine_rows);
        if (quality.back_share < 0.01 && quality.escaped_share < 0.6)
            result.push_back(camera);
    }
    return result;
}

} // namespace

Camera automatic_camera(const Scene& scene, double aspect, Vec3 up)
{
    if (!(length(up) > 0.0) || !std::isfinite(length(up)))
        throw SettingsError("camera: the up direction must be a finite vector that is not zero");
    const Room room = room_of(scene, up);
    const std::vector<Camera> outside = outside_cameras(room, up, field_of_view(45.0, 60.0, aspect), aspect);
    const std::vector<Camera> open = unobstructed(scene, outside, aspect);
    if (!open.empty())
        return best_cameras(scene, open, aspect, fine_rows, 1).front();

    std::vector<Camera> cameras = outside;
    for (const double vertical : {58.0, 68.0})
        append_inside(room, up, field_of_view(vertical, vertical + 20.0, aspect), cameras);
    append_behind_walls(room, up, field_of_view(54.0, 74.0, aspect), cameras);
    const std::vector<Camera> shortlist = best_cameras(scene, cameras, aspect, coarse_rows, 8);
    return best_cameras(scene, shortlist, aspect, fine_rows, 1).front();
}

} // namespace multipath
