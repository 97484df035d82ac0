#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Intersection of a line with a surface.
struct Hit
{
    double t = 0.0;            ///< line parameter
    std::uint32_t surface = 0; ///< index of the surface
    double u = 0.0;            ///< surface coordinates, 0 ... 1
    double v = 0.0;
    bool front = false; ///< arrival: the line meets the front; else departure: from the back, out through the front
};

/// True if two faces that a line meets at the same point seem to have the same corners, judged by (u, v) alone.
bool have_same_outline(const Hit& a, const Hit& b);

/// Reorders groups of hits with equal t, in hits sorted by t, as the line passes the coincident surfaces: arrivals
/// (meeting a front) and departures (leaving through a front) alternate, as they do in every sound scene. Several
/// arrivals keep their order in the list and several departures reverse it, so that a line and its reverse agree.
/// `starts_in_solid` is the assumption about the start of the line if no hit decides. Even then a first group that is
/// all the line meets, or that consists of two faces with the same outline, is a thin sheet.
void order_coincident_hits(Hit* hits, std::size_t count, bool starts_in_solid);

inline void order_coincident_hits(std::vector<Hit>& hits, bool starts_in_solid)
{
    order_coincident_hits(hits.data(), hits.size(), starts_in_solid);
}

} // namespace multipath
