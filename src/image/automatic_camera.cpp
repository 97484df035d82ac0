// The camera is found by search. The candidates stand in rooms, from points in free space above lit surfaces as far
// back as the wall or beyond it, since its back is transparent; and around the scene, as near as all of it fits into
// the picture. A coarse grid of rays scores them. In daylight the outside is lit, too. Then a view of a room or
// courtyard is preferred to any from outside, and that shows what rises above the ground.

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

/// A box around the scene with `up` as its second axis, so that scenes of any orientation are treated alike.
struct Frame
{
    Vec3 axis_x, axis_y, axis_z; ///< unit vectors, y up
    Bounds box;                  ///< in these axes

    /// The coordinates of a point in these axes.
    Vec3 place_of(Vec3 point) const { return {dot(point, axis_x), dot(point, axis_y), dot(point, axis_z)}; }
    /// The point with these coordinates.
    Vec3 at(Vec3 place) const { return place.x * axis_x + place.y * axis_y + place.z * axis_z; }
    /// Direction k of eight level ones, or one between two of them, with a slope.
    Vec3 direction(double k, double slope) const
    {
        const SinCos turn = sin_cos_of_turns(k / 8.0);
        return normalized(turn.cos * axis_x + turn.sin * axis_z + slope * axis_y);
    }
};

/// The box, in the axes of a frame, of all surfaces that rise above a height in these axes.
Bounds box_above(const Scene& scene, const Frame& axes, double height)
{
    Bounds result;
    for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s) {
        Bounds box;
        for (const Vec3 corner : corners_of(scene.surfaces()[s]))
            box.include(axes.place_of(corner));
        if (box.high.y > height)
            result.include(box);
    }
    return result;
}

/// The frame of the scene, or in daylight of what rises above its ground.
Frame frame_of(const Scene& scene, Vec3 up)
{
    Frame frame;
    frame.axis_y = normalized(up);
    const Vec3 toward = std::abs(frame.axis_y.z) < 0.9 ? Vec3{0.0, 0.0, 1.0} : Vec3{0.0, -1.0, 0.0};
    frame.axis_x = normalized(cross(frame.axis_y, toward));
    frame.axis_z = cross(frame.axis_x, frame.axis_y);
    frame.box = box_above(scene, frame, -Bounds::infinity);
    const Bounds raised = box_above(scene, frame, frame.box.low.y + 0.05 * frame.box.size().y);
    if (has_daylight(scene) && !raised.empty())
        frame.box = raised;
    return frame;
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

/// [degrees] Vertical field of view, reduced in wide pictures so that the horizontal one is at most `widest`: otherwise
/// their sides would look stretched.
double field_of_view(double vertical, double widest, double aspect)
{
    const double from_width =
        2.0 / radians_per_degree * elementary::atan(elementary::tan(0.5 * widest * radians_per_degree) / aspect);
    return std::min(vertical, from_width);
}

/// A point in free space.
struct Place
{
    Vec3 point;
    std::vector<std::optional<double>> paths; ///< free paths in the eight level directions
};

/// Places in rooms and courts, at eye height halfway between a lit patch and what is opposite to it: at most one of the
/// level rays leaves the scene, as through a window. The first is the middle of the scene if that is in a room.
std::vector<Place> places_within(const LitScene& lit_scene, const Frame& frame)
{
    constexpr int points = 64;
    const Scene& scene = lit_scene.scene;
    DiscreteDistribution areas;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        areas.add(lit_scene.is_lit(i) ? scene.area(i) : 0.0);
    std::vector<Vec3> starts = {frame.at(frame.box.centre())};
    for (int k = 0; k < points && areas.total() > 0.0; ++k) {
        const Patch patch = scene.patch(static_cast<std::uint32_t>(areas.at((k + 0.5) / points)));
        const Line away = {patch.shape.centre(), patch.shape.normal()};
        const std::optional<Hit> opposite = scene.intersector().closest_hit_from(patch.surface, away);
        const bool is_open = !opposite || scene.is_sky(opposite->surface);
        starts.push_back(away.at(is_open ? 0.05 * frame.box.diagonal() : 0.5 * opposite->t));
    }
    std::vector<Place> places;
    for (const Vec3 start : starts) {
        const std::vector<std::optional<double>> upright =
            free_paths(scene, {{start, frame.axis_y}, {start, -frame.axis_y}});
        if (!upright[1])
            continue;
        const double height =
            *upright[1] + upright[0].value_or(std::max(0.0, frame.box.high.y - dot(start, frame.axis_y)));
        const Vec3 point = start + (0.6 * height - *upright[1]) * frame.axis_y;
        std::vector<Line> level;
        for (int d = 0; d < 8; ++d)
            level.push_back({point, frame.direction(d, 0.0)});
        const std::vector<std::optional<double>> paths = free_paths(scene, level);
        if (std::count(paths.begin(), paths.end(), std::nullopt) <= 1)
            places.push_back({point, paths});
    }
    return places;
}

/// Cameras in rooms, at the walls, and behind them for rooms that are too small to step back in.
std::vector<Camera> cameras_within(const LitScene& lit_scene, const Frame& frame, Vec3 up, double aspect)
{
    constexpr std::size_t most_places = 32;
    const std::vector<Place> places = places_within(lit_scene, frame);
    const std::size_t step = places.size() / most_places + 1;
    std::vector<Camera> cameras;
    for (std::size_t k = 0; k < places.size(); k += step)
        for (int d = 0; d < 8; ++d)
            for (const double share : {0.9, 1.4, 1.8}) {
                const std::optional<double> back = places[k].paths[static_cast<std::size_t>((d + 4) % 8)];
                if (!(back > 0.0) || (share > 1.0 && has_daylight(lit_scene.scene)))
                    continue;
                const Vec3 eye = places[k].point - share * *back * frame.direction(d, 0.0);
                cameras.push_back({eye, eye + *back * frame.direction(d, -0.16), up,
                                   field_of_view(share > 1.0 ? 54.0 : 64.0, 80.0, aspect)});
            }
    return cameras;
}

/// Cameras on all sides, as near as the box of the frame fits into the picture. Outdoors there is a margin, and they
/// look at corners rather than straight at walls.
std::vector<Camera> cameras_around(const Frame& frame, bool outdoors, Vec3 up, double aspect)
{
    const double margin = outdoors ? 1.1 : 1.0;
    const double angle = field_of_view(45.0, 60.0, aspect);
    const double half_height = elementary::tan(0.5 * angle * radians_per_degree);
    const Vec3 centre = frame.at(frame.box.centre());
    std::vector<Camera> cameras;
    for (int k = 0; k < 8; ++k)
        for (const double slope : {0.0, 0.4}) {
            const Vec3 direction = frame.direction(outdoors ? k + 0.5 : k, slope);
            const Vec3 right = normalized(cross(frame.axis_y, direction));
            const Vec3 above = cross(direction, right);
            double distance = 0.1 * frame.box.diagonal();
            for (const double x : {frame.box.low.x, frame.box.high.x})
                for (const double y : {frame.box.low.y, frame.box.high.y})
                    for (const double z : {frame.box.low.z, frame.box.high.z}) {
                        const Vec3 corner = frame.at({x, y, z}) - centre;
                        const double aside =
                            std::max(std::abs(dot(corner, above)), std::abs(dot(corner, right)) / aspect);
                        distance = std::max(distance, aside / half_height + dot(corner, direction));
                    }
            cameras.push_back({centre + margin * distance * direction, centre, up, angle});
        }
    return cameras;
}

} // namespace

Camera automatic_camera(const Scene& scene, double aspect, Vec3 up, const std::vector<Rgb>& radiosity)
{
    constexpr int rows = 12;
    if (!(length(up) > 0.0) || !std::isfinite(length(up)))
        throw SettingsError("camera: the up direction must be a finite vector that is not zero");
    const Frame frame = frame_of(scene, up);
    const LitScene lit_scene(scene, radiosity, frame.box.diagonal());
    std::vector<Camera> cameras = cameras_within(lit_scene, frame, up, aspect);
    const std::size_t within = cameras.size();
    if (cameras.empty() || !has_daylight(scene)) {
        const std::vector<Camera> around = cameras_around(frame, has_daylight(scene), up, aspect);
        cameras.insert(cameras.end(), around.begin(), around.end());
    }
    const Camera* best = nullptr;
    double highest = 0.0;
    for (std::size_t k = 0; k < cameras.size(); ++k) {
        const ViewQuality quality = view_quality(lit_scene, cameras[k], aspect, rows);
        const bool is_through_opening =
            k >= within && quality.back_share < 0.01 && quality.escaped_share + quality.dark_share < 0.6;
        const double score = quality.score + (is_through_opening ? 1.0 : 0.0);
        if (best == nullptr || score > highest) {
            best = &cameras[k];
            highest = score;
        }
    }
    return *best;
}

} // namespace multipath
