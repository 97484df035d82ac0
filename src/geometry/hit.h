#pragma once

#include <cstddef>
#include <cstdint>

namespace multipath {

/// Intersection of a line with a surface.
struct Hit
{
    double t = 0.0;            ///< parameter of the point on the Line
    std::uint32_t surface = 0; ///< index of the surface in the SurfaceList
    double u = 0.0;            ///< coordinates of the point on the Surface, 0 ... 1
    double v = 0.0;
    bool front = false; ///< true: arrival, the line meets the front; false: departure, it leaves through the front
};

/// True if two faces that a line meets at the same point seem to have the same corners, in any order. This is judged by
/// the (u, v) of the two hits alone.
bool have_same_outline(const Hit& a, const Hit& b);

/// Reorders each group of hits with equal t, in a list sorted by t, to the order in which the line passes the
/// coincident surfaces: arrivals (meeting a front) and departures (leaving through a front) alternate, but a line
/// leaves all solids that it is inside before it arrives. Within a group, arrivals stay in the order of the list and
/// departures are put in the opposite order. On the reversed line, arrivals and departures change places. So if its
/// list has the hits of a group in the same order, the two lines pass the surfaces of the group in opposite orders. If
/// no hit shows whether the line starts inside a solid, `starts_in_solid` decides; hit.cpp states the rules and their
/// exceptions (thin sheets, floors met from below). `comes_from_sky`: lines may also meet walls from outside.
void order_coincident_hits(Hit* hits, std::size_t count, bool starts_in_solid, bool comes_from_sky = false);

} // namespace multipath
