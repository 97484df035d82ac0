// Coincident faces that look at each other are either a gap of no width (a box standing on a floor: departure, then
// arrival) or the two sides of a thin sheet (arrival, then departure). Which it is depends on where the line comes
// from: out of a solid, whose inside it left or will leave by a departure, or out of the open, which ends with an
// arrival. A line that starts with coincident faces is judged by the first hit that is not ambiguous: a gap as well as
// a sheet leave it where it was before.

#include "geometry/hit.h"

#include <algorithm>
#include <cstddef>

namespace multipath {

namespace {

std::size_t end_of_group(const std::vector<Hit>& hits, std::size_t first)
{
    std::size_t last = first + 1;
    while (last < hits.size() && hits[last].t == hits[first].t)
        ++last;
    return last;
}

bool first_is_arrival(const std::vector<Hit>& hits, bool starts_in_solid)
{
    for (std::size_t first = 0; first < hits.size(); first = end_of_group(hits, first)) {
        std::ptrdiff_t arrivals_too_many = 0;
        for (std::size_t i = first; i < end_of_group(hits, first); ++i)
            arrivals_too_many += hits[i].front ? 1 : -1;
        if (arrivals_too_many != 0)
            return arrivals_too_many > 0;
    }
    return !starts_in_solid;
}

/// Orders hits[first .. last), all of one t.
void order_group(std::vector<Hit>& hits, std::size_t first, std::size_t last, bool arrival_expected)
{
    const auto at = [&](std::size_t i) { return hits.begin() + static_cast<std::ptrdiff_t>(i); };
    std::vector<Hit> arrivals;
    std::vector<Hit> departures;
    for (std::size_t i = first; i < last; ++i)
        (hits[i].front ? arrivals : departures).push_back(hits[i]);
    std::reverse(departures.begin(), departures.end());

    auto arrival = arrivals.begin();
    auto departure = departures.begin();
    for (auto place = at(first); place != at(last); ++place) {
        const bool take_arrival = departure == departures.end() || (arrival_expected && arrival != arrivals.end());
        *place = take_arrival ? *arrival++ : *departure++;
        arrival_expected = !take_arrival;
    }
}

} // namespace

void order_coincident_hits(std::vector<Hit>& hits, bool starts_in_solid)
{
    for (std::size_t first = 0; first + 1 < hits.size();) {
        const std::size_t last = end_of_group(hits, first);
        if (last - first > 1)
            order_group(hits, first, last,
                        first > 0 ? !hits[first - 1].front : first_is_arrival(hits, starts_in_solid));
        first = last;
    }
}

} // namespace multipath
