// Of a million surfaces hardly any reaches the hull. The corners that lie farthest out in a few directions span a body
// that almost fills it; what lies inside of that body cannot be a corner of the hull.

#include "geometry/surface_hull.h"

#include "geometry/vec3.h"

#include <array>
#include <cstddef>

namespace multipath {

namespace {

constexpr std::size_t few = 4096; ///< surfaces; fewer are not worth a selection

template <class Visit>
void for_each_corner(const std::vector<Surface>& surfaces, const Visit& visit)
{
    for (const Surface& surface : surfaces) {
        visit(surface.origin);
        visit(surface.at(1.0, 0.0));
        visit(surface.at(0.0, 1.0));
        if (surface.shape == Shape::parallelogram)
            visit(surface.at(1.0, 1.0));
    }
}

/// The corners farthest out along the axes and the diagonals of a cube, both ways.
std::vector<Vec3> extreme_corners(const std::vector<Surface>& surfaces)
{
    constexpr std::size_t directions = 7;
    const auto places_along = [](Vec3 p) {
        return std::array<double, directions>{
            p.x, p.y, p.z, p.x + p.y + p.z, p.x + p.y - p.z, p.x - p.y + p.z, p.y + p.z - p.x};
    };
    const Vec3 any = surfaces.front().origin;
    std::array<double, directions> low = places_along(any);
    std::array<double, directions> high = low;
    std::vector<Vec3> extremes(2 * directions, any);
    for_each_corner(surfaces, [&](Vec3 p) {
        const std::array<double, directions> place = places_along(p);
        for (std::size_t k = 0; k < directions; ++k) {
            if (place[k] < low[k]) {
                low[k] = place[k];
                extremes[k] = p;
            }
            if (place[k] > high[k]) {
                high[k] = place[k];
                extremes[directions + k] = p;
            }
        }
    });
    return extremes;
}

} // namespace

ConvexHull hull_of(const std::vector<Surface>& surfaces)
{
    std::vector<Vec3> corners;
    if (surfaces.size() <= few) {
        for_each_corner(surfaces, [&](Vec3 p) { corners.push_back(p); });
        return ConvexHull(corners);
    }
    const std::vector<Vec3> extremes = extreme_corners(surfaces);
    const ConvexHull body(extremes);
    corners = extremes;
    for_each_corner(surfaces, [&](Vec3 p) {
        if (!body.holds(p))
            corners.push_back(p);
    });
    return ConvexHull(corners);
}

} // namespace multipath
