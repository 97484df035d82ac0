// Coincident faces that look at each other are either a gap of no width (a box standing on a floor: departure, then
// arrival) or the two sides of a thin sheet (arrival, then departure). Which it is depends on where the line comes
// from: out of a solid, whose inside it left or will leave by a departure, or out of the open, which ends with an
// arrival. A line that starts with coincident faces is judged by the first hit that is not ambiguous: a gap as well as
// a sheet leave it where it was before. Where no hit tells, two faces of the same outline are a sheet, and so is what a
// line meets that meets nothing else: through a gap it would pass from one solid to another without ever having been
// outside. A line out of the open that will leave a solid passes two faces of unlike outline as a gap, too: the ground
// below a house is a sheet that nobody modelled from below. Of the rest the kind of scene decides: from wall to wall of
// a room through a cupboard that fills a niche.

#include "geometry/hit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace multipath {

namespace {

std::size_t end_of_group(const Hit* hits, std::size_t count, std::size_t first)
{
    std::size_t last = first + 1;
    while (last < count && hits[last].t == hits[first].t)
        ++last;
    return last;
}

/// Distances of a point of a parallelogram from the nearer end of each edge; those of a face with the same corners are
/// the same, in whichever order it names them.
std::array<double, 2> places_on_parallelogram(const Hit& hit)
{
    const double a = std::min(hit.u, 1.0 - hit.u);
    const double b = std::min(hit.v, 1.0 - hit.v);
    return {std::min(a, b), std::max(a, b)};
}

/// Barycentric coordinates on a triangle, from small to large: likewise.
std::array<double, 3> places_on_triangle(const Hit& hit)
{
    std::array<double, 3> places = {hit.u, hit.v, 1.0 - hit.u - hit.v};
    std::sort(places.begin(), places.end());
    return places;
}

template <std::size_t n>
bool agree(const std::array<double, n>& a, const std::array<double, n>& b)
{
    constexpr double rounding = 1e-9;
    return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return std::abs(x - y) < rounding; });
}

/// By how many the arrivals outnumber the departures in the first group where they are not as many; 0 without one.
std::ptrdiff_t next_balance(const Hit* hits, std::size_t count, std::size_t first)
{
    std::ptrdiff_t arrivals_too_many = 0;
    while (first < count && arrivals_too_many == 0)
        for (const std::size_t last = end_of_group(hits, count, first); first < last; ++first)
            arrivals_too_many += hits[first].front ? 1 : -1;
    return arrivals_too_many;
}

bool first_is_arrival(const Hit* hits, std::size_t count, bool starts_in_solid)
{
    if (const std::ptrdiff_t balance = next_balance(hits, count, 0); balance != 0)
        return balance > 0;
    const std::size_t first_place = end_of_group(hits, count, 0);
    return !starts_in_solid || first_place == count || (first_place == 2 && have_same_outline(hits[0], hits[1]));
}

/// Comes a line out of the open to a floor that is seen from below, and to the bottom of a solid that stands on it? The
/// back of the floor belongs to no solid, but behind both the line leaves one.
bool is_floor_from_below(const Hit* hits, std::size_t count, std::size_t first, std::size_t last)
{
    return last - first == 2 && hits[first].front != hits[first + 1].front && !hits[first - 1].front &&
           !have_same_outline(hits[first], hits[first + 1]) && next_balance(hits, count, last) < 0;
}

/// Orders the hits first ... last, all of one t.
void order_group(Hit* first, Hit* last, bool arrival_expected)
{
    if (last - first == 2) { // nearly always; nothing but a swap
        if (first->front == last[-1].front ? !first->front : first->front != arrival_expected)
            std::swap(*first, last[-1]);
        return;
    }
    std::vector<Hit> arrivals;
    std::vector<Hit> departures;
    for (const Hit* hit = first; hit != last; ++hit)
        (hit->front ? arrivals : departures).push_back(*hit);
    std::reverse(departures.begin(), departures.end());

    auto arrival = arrivals.begin();
    auto departure = departures.begin();
    for (Hit* place = first; place != last; ++place) {
        const bool take_arrival = departure == departures.end() || (arrival_expected && arrival != arrivals.end());
        *place = take_arrival ? *arrival++ : *departure++;
        arrival_expected = !take_arrival;
    }
}

} // namespace

bool have_same_outline(const Hit& a, const Hit& b)
{
    return agree(places_on_parallelogram(a), places_on_parallelogram(b)) ||
           agree(places_on_triangle(a), places_on_triangle(b));
}

void order_coincident_hits(Hit* hits, std::size_t count, bool starts_in_solid)
{
    for (std::size_t first = 0; first + 1 < count;) {
        const std::size_t last = end_of_group(hits, count, first);
        if (last - first > 1)
            order_group(hits + first, hits + last,
                        first == 0 ? first_is_arrival(hits, count, starts_in_solid)
                                   : !hits[first - 1].front && !is_floor_from_below(hits, count, first, last));
        first = last;
    }
}

} // namespace multipath
