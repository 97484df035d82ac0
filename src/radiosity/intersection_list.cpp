#include "radiosity/intersection_list.h"

#include <algorithm>

namespace multipath {

namespace {

/// Orders hits[first .. last), all of one t, knowing what comes before and after.
void order_group(std::vector<Hit>& hits, std::size_t first, std::size_t last)
{
    // Coincident faces that face each other are a gap (departure, then arrival) or a sheet (arrival, then departure).
    // What came before decides; at the start of a line, what comes next: out of a gap one gets inside a solid,
    // which the line leaves by a departure.
    const bool next_departs = last < hits.size() && !hits[last].front;
    bool arrival_expected = first > 0 ? !hits[first - 1].front : !next_departs;
    for (std::size_t place = first; place < last; ++place) {
        std::size_t chosen = place;
        while (chosen < last && hits[chosen].front != arrival_expected)
            ++chosen;
        if (chosen == last)
            chosen = place;
        // Rotate rather than swap: hits that are alike stay in the order of their surfaces.
        const auto begin = hits.begin();
        const auto at = [&](std::size_t i) { return begin + static_cast<std::ptrdiff_t>(i); };
        std::rotate(at(place), at(chosen), at(chosen + 1));
        arrival_expected = !hits[place].front;
    }
}

std::uint32_t patch_or_behind(const Scene& scene, const Hit& hit, bool front)
{
    const std::uint32_t patch = scene.patch_at(hit.surface, hit.u, hit.v, front);
    return patch == Scene::no_patch ? Segment::behind : patch;
}

} // namespace

void order_coincident_hits(std::vector<Hit>& hits)
{
    for (std::size_t first = 0; first + 1 < hits.size(); ++first) {
        std::size_t last = first + 1;
        while (last < hits.size() && hits[last].t == hits[first].t)
            ++last;
        if (last - first > 1)
            order_group(hits, first, last);
        first = last - 1;
    }
}

void append_segments(const Scene& scene, const std::vector<Hit>& hits, std::vector<Segment>& segments)
{
    std::uint32_t from = Segment::outside;
    const auto append = [&](std::uint32_t to) {
        if (Segment::is_patch(from) || Segment::is_patch(to))
            segments.push_back({from, to});
    };
    for (const Hit& hit : hits) {
        append(patch_or_behind(scene, hit, hit.front)); // the side that the line arrives at
        from = patch_or_behind(scene, hit, !hit.front); // the side that it leaves
    }
    if (!hits.empty())
        append(Segment::outside);
}

} // namespace multipath
