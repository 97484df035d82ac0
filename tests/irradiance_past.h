#pragma once

#include "geometry/polygon.h"
#include "geometry/surface.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace multipath {

// How irradiance_past() works: the polygon of the lamp is clipped by the horizon of the point. Each blocker then
// removes its shadow from what is left: the part inside the pyramid from the point through the edges of the blocker,
// and farther away than the plane of the blocker. A plane cuts a convex polygon into two convex ones, so the visible
// region is a list of convex polygons. Lambert's formula gives the irradiance from each.

using Polygon = std::vector<Vec3>; ///< convex, with any number of corners

/// The parts of a polygon on both sides of a plane.
struct Halves
{
    Polygon front;
    Polygon back;
};

/// Cuts a polygon by the plane through a point with this normal.
inline Halves cut(const Polygon& polygon, Vec3 origin, Vec3 normal)
{
    Halves result;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 from = polygon[k];
        const Vec3 to = polygon[(k + 1) % polygon.size()];
        const double here = dot(from - origin, normal);
        const double there = dot(to - origin, normal);
        if (here >= 0.0)
            result.front.push_back(from);
        if (here <= 0.0)
            result.back.push_back(from);
        if ((here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0)) {
            const Vec3 between = from + (here / (here - there)) * (to - from);
            result.front.push_back(between);
            result.back.push_back(between);
        }
    }
    return result;
}

/// Appends the parts of a polygon that are visible from the point past a blocker: the part outside each plane through
/// the point and an edge of the blocker, and of the rest the part in front of the blocker's plane.
inline void add_seen(Polygon rest, const Surface& blocker, Vec3 point, std::vector<Polygon>& seen)
{
    const std::vector<Vec3> corners = corners_of(blocker);
    const double side = dot(blocker.centre() - point, blocker.normal()) < 0.0 ? -1.0 : 1.0;
    for (std::size_t k = 0; k < corners.size() && rest.size() > 2; ++k) {
        const Vec3 inward = side * cross(corners[k] - point, corners[(k + 1) % corners.size()] - point);
        Halves halves = cut(rest, point, inward);
        seen.push_back(std::move(halves.back));
        rest = std::move(halves.front);
    }
    seen.push_back(cut(rest, blocker.centre(), side * blocker.normal()).back);
}

/// [1] Exact irradiance at a point with this unit normal from a lamp of radiosity 1 that opaque surfaces occlude in
/// part; 0 behind the lamp, which emits at its front. The polygon of the lamp is clipped by the horizon (the plane
/// through the point with the normal) and by the shadow of every blocker, and the visible parts are integrated by
/// Lambert's formula. The point must not lie in the plane of a blocker.
inline double irradiance_past(const std::vector<Surface>& blockers, const Surface& lamp, Vec3 point, Vec3 normal)
{
    if (dot(point - lamp.centre(), lamp.normal()) <= 0.0)
        return 0.0;
    std::vector<Polygon> parts = {cut(corners_of(lamp), point, normal).front};
    for (const Surface& blocker : blockers) {
        std::vector<Polygon> seen;
        for (Polygon& part : parts)
            add_seen(std::move(part), blocker, point, seen);
        parts = std::move(seen);
    }
    double sum = 0.0;
    for (const Polygon& part : parts)
        for (std::size_t k = 2; k < part.size(); ++k) {
            FlatPolygon triangle;
            for (const Vec3 corner : {part[0], part[k - 1], part[k]})
                triangle.add(corner);
            sum += irradiance_from(triangle, point, normal);
        }
    return sum;
}

} // namespace multipath
