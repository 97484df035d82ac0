#include "geometry/intersector/plane_neighbours.h"

#include <algorithm>
#include <numeric>

namespace multipath {

namespace {

bool overlap(const Bounds& a, const Bounds& b)
{
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
           a.low.z <= b.high.z && b.low.z <= a.high.z;
}

} // namespace

PlaneNeighbours::PlaneNeighbours(const LargeVector<Bounds>& boxes, const std::vector<std::uint32_t>& plane_number)
    : first_(boxes.size(), 0)
{
    // Counting sort of the surfaces by plane.
    std::vector<std::uint32_t> plane_end(
        plane_number.empty() ? 1 : 1 + *std::max_element(plane_number.begin(), plane_number.end()), 0);
    for (const std::uint32_t plane : plane_number)
        ++plane_end[plane];
    std::partial_sum(plane_end.begin(), plane_end.end(), plane_end.begin());
    std::vector<std::uint32_t> place = plane_end;
    std::vector<std::uint32_t> by_plane(boxes.size());
    for (auto s = static_cast<std::uint32_t>(boxes.size()); s-- > 0;)
        by_plane[--place[plane_number[s]]] = s;

    for (std::uint32_t s = 0; s < boxes.size(); ++s) {
        const std::uint32_t plane = plane_number[s];
        const std::uint32_t first = place[plane];
        const std::uint32_t last = plane_end[plane];
        if (last - first > most_in_plane) {
            first_[s] = unlisted;
            continue;
        }
        const std::size_t own = neighbours_.size();
        for (std::uint32_t i = first; i < last; ++i)
            if (by_plane[i] != s && overlap(boxes[s], boxes[by_plane[i]]))
                neighbours_.push_back(by_plane[i]);
        if (neighbours_.size() > own) {
            first_[s] = static_cast<std::uint32_t>(own);
            neighbours_.push_back(end_of_list);
        }
    }
}

} // namespace multipath
