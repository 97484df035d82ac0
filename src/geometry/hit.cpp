// Order of hits at the same t. Two coincident faces of opposite orientation are either a gap of width zero (a box that
// stands on a floor: departure, then arrival) or the two sides of a thin sheet (arrival, then departure). Which of the
// two depends on the medium the line comes from: inside a solid the next hit is a departure, in the open an arrival.
// The previous hit shows the medium, where surfaces enclose solids. In the open, where they may not, two faces of the
// same outline are always a sheet, such as a lamp and its cover. At the start of the line these rules apply, in this
// order:
//
// 1. The first group of hits with unequal numbers of arrivals and departures decides, because neither a gap nor a sheet
//    changes the medium.
// 2. Otherwise two faces of the same outline are a sheet, and so is a group that is all the line meets: through a gap
//    the line would pass from one solid to another without ever being outside.
// 3. Otherwise the kind of scene decides (`starts_in_solid`): in a room the line may pass from wall to wall through a
//    cupboard that fills a niche. For lines from a sky this goes before the first part of rule 2: they would light the
//    back of the cupboard, and through the gap the wall, if the outline of the wall is the same.
//
// There is one exception after the start: a line in the open that meets two faces of different outline and leaves a
// solid later passes a gap, not a sheet. An example is the ground below a house, a floor without an underside.

#include "geometry/hit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace multipath {

namespace {

/// End of the group of hits with equal t that begins at `first`.
std::size_t end_of_group(const Hit* hits, std::size_t count, std::size_t first)
{
    std::size_t last = first + 1;
    while (last < count && hits[last].t == hits[first].t)
        ++last;
    return last;
}

/// Coordinates on a parallelogram that do not depend on the order of its corners: the distances to the nearer of each
/// pair of opposite sides, sorted.
std::array<double, 2> invariant_on_parallelogram(const Hit& hit)
{
    const double a = std::min(hit.u, 1.0 - hit.u);
    const double b = std::min(hit.v, 1.0 - hit.v);
    return {std::min(a, b), std::max(a, b)};
}

/// Coordinates on a triangle that do not depend on the order of its corners: the barycentric coordinates, sorted.
std::array<double, 3> invariant_on_triangle(const Hit& hit)
{
    std::array<double, 3> barycentric = {hit.u, hit.v, 1.0 - hit.u - hit.v};
    std::sort(barycentric.begin(), barycentric.end());
    return barycentric;
}

/// True if the coordinates are equal up to rounding.
template <std::size_t n>
bool agree(const std::array<double, n>& a, const std::array<double, n>& b)
{
    constexpr double rounding = 1e-9;
    return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return std::abs(x - y) < rounding; });
}

/// Arrivals minus departures in the first group, from hit `first` on, where they differ in number; 0 if there is none.
std::ptrdiff_t next_balance(const Hit* hits, std::size_t count, std::size_t first)
{
    std::ptrdiff_t arrivals_too_many = 0;
    while (first < count && arrivals_too_many == 0)
        for (const std::size_t last = end_of_group(hits, count, first); first < last; ++first)
            arrivals_too_many += hits[first].front ? 1 : -1;
    return arrivals_too_many;
}

/// True for two faces back to back with the same outline.
bool is_sheet(const Hit* hits, std::size_t first, std::size_t last)
{
    return last - first == 2 && hits[first].front != hits[first + 1].front &&
           have_same_outline(hits[first], hits[first + 1]);
}

/// True if the first group of hits of a line begins with an arrival: rules 1 to 3 above.
bool first_is_arrival(const Hit* hits, std::size_t count, bool starts_in_solid, bool comes_from_sky)
{
    if (const std::ptrdiff_t balance = next_balance(hits, count, 0); balance != 0)
        return balance > 0;
    const std::size_t first_place = end_of_group(hits, count, 0);
    return !starts_in_solid || first_place == count || (!comes_from_sky && is_sheet(hits, 0, first_place));
}

/// True if a line in the open comes from below to a floor and the bottom of a solid that stands on it: the exception
/// above. The back of the floor belongs to no solid, but farther along the line leaves one.
bool is_floor_from_below(const Hit* hits, std::size_t count, std::size_t first, std::size_t last)
{
    return last - first == 2 && hits[first].front != hits[first + 1].front && !hits[first - 1].front &&
           !is_sheet(hits, first, last) && next_balance(hits, count, last) < 0;
}

/// The number of solids that a line is inside before the group that begins at hit `first`: the least with which it is
/// nowhere inside fewer than none.
std::ptrdiff_t solids_around(const Hit* hits, std::size_t count, std::size_t first)
{
    std::ptrdiff_t depth = 0;
    std::ptrdiff_t least = 0;
    std::ptrdiff_t wanted = 0;
    for (std::size_t next = 0; next < count;) {
        wanted = next == first ? depth : wanted;
        for (const std::size_t last = end_of_group(hits, count, next); next < last; ++next)
            depth += hits[next].front ? 1 : -1;
        least = std::min(least, depth);
    }
    return wanted - least;
}

/// Orders two hits with the same t.
void order_pair(Hit* hits, bool arrival_expected)
{
    if (hits[0].front == hits[1].front ? !hits[0].front : hits[0].front != arrival_expected)
        std::swap(hits[0], hits[1]);
}

/// Orders the hits first ... last - 1, all with the same t: the line leaves the solids around, arrives, and leaves what
/// it arrived at. So solids that overlap and stand on one floor are all left before the line arrives at the floor.
void order_group(Hit* first, Hit* last, std::ptrdiff_t solids)
{
    std::vector<Hit> arrivals;
    std::vector<Hit> departures;
    for (const Hit* hit = first; hit != last; ++hit)
        (hit->front ? arrivals : departures).push_back(*hit);
    std::reverse(departures.begin(), departures.end());

    auto arrival = arrivals.begin();
    auto departure = departures.begin();
    for (Hit* next = first; next != last; ++next) {
        const bool arrives = departure == departures.end() || (solids <= 0 && arrival != arrivals.end());
        *next = arrives ? *arrival++ : *departure++;
        solids += arrives ? 1 : -1;
    }
}

} // namespace

bool have_same_outline(const Hit& a, const Hit& b)
{
    return agree(invariant_on_parallelogram(a), invariant_on_parallelogram(b)) ||
           agree(invariant_on_triangle(a), invariant_on_triangle(b));
}

void order_coincident_hits(Hit* hits, std::size_t count, bool starts_in_solid, bool comes_from_sky)
{
    const auto arrivals = std::count_if(hits, hits + count, [](const Hit& hit) { return hit.front; });
    const bool encloses_solids = starts_in_solid && 2 * static_cast<std::size_t>(arrivals) == count;
    for (std::size_t first = 0; first + 1 < count;) {
        const std::size_t last = end_of_group(hits, count, first);
        if (last - first > 1) {
            const bool arrival_expected =
                (!encloses_solids && is_sheet(hits, first, last)) ||
                (first == 0 ? first_is_arrival(hits, count, starts_in_solid, comes_from_sky)
                            : !hits[first - 1].front && !is_floor_from_below(hits, count, first, last));
            if (last - first == 2) // nearly always
                order_pair(hits + first, arrival_expected);
            else
                order_group(hits + first, hits + last,
                            std::max<std::ptrdiff_t>(solids_around(hits, count, first), arrival_expected ? 0 : 1));
        }
        first = last;
    }
}

} // namespace multipath
