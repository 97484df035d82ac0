#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// One meeting of a line with a surface.
struct Hit
{
    double t = 0.0;            ///< parameter of the line
    std::uint32_t surface = 0; ///< number of the surface
    double u = 0.0;            ///< position on the surface, 0 ... 1
    double v = 0.0;
    bool front = false; ///< the line arrives at the front; otherwise it comes from behind and leaves through the front
};

/// True if two faces that a line meets at one place seem to have the same corners.
bool have_same_outline(const Hit& a, const Hit& b);

/// Puts hits of equal t, already sorted by t, in the order in which a line passes coincident surfaces: departures
/// (leaving through a front) and arrivals (meeting a front) alternate, as they do in every sound scene. Of several
/// arrivals the first in the list is met first, of several departures the last one, so that a line and its reverse see
/// the same. `starts_in_solid`: what the beginning of the line is taken for when nothing along it tells; two faces with
/// the same outline are the sides of a thin sheet then.
void order_coincident_hits(Hit* hits, std::size_t count, bool starts_in_solid);

inline void order_coincident_hits(std::vector<Hit>& hits, bool starts_in_solid)
{
    order_coincident_hits(hits.data(), hits.size(), starts_in_solid);
}

} // namespace multipath
