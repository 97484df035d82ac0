// Lists, for each surface, the coplanar surfaces that overlap it. A thread makes the lists for a block of 1024 surfaces
// at a time; all lists are concatenated at the end. The candidates of a list are all surfaces in the plane, if there
// are few, else those that the hierarchy has near the surface. Limits keep time and memory linear: a surface that
// exceeds a limit stays unlisted, and queries about this surface search the hierarchy.

#include "geometry/intersector/core.h"

#include "geometry/polygon.h"
#include "parallel/blocks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace multipath {

namespace {

constexpr std::uint32_t few_in_plane = 32;         ///< up to this number, all pairs in a plane are compared
constexpr std::size_t most_looked_at = 4096;       ///< limit of candidates for one surface
constexpr std::uint32_t surfaces_at_a_time = 1024; ///< block of surfaces that one thread does at a time
constexpr std::size_t many_listed = 131072;        ///< once a block has so many entries ...
constexpr std::size_t long_list = 256;             ///< ... no longer lists are added to it, so that memory stays linear

/// True if an edge of `a`, which has this normal, has all of `b` on its outer side, up to `slack`.
bool is_separated_from(const FlatPolygon& a, Vec3 normal, const FlatPolygon& b, double slack)
{
    for (std::size_t i = 0; i < a.size; ++i) {
        const Vec3 outwards = cross(a.next(i) - a.corners[i], normal);
        if (heights(b, a.corners[i], outwards).low >= -slack * length(outwards))
            return true;
    }
    return false;
}

/// True if two surfaces in one plane overlap by more than their borders. Separating axis test for convex polygons: the
/// axes are the normals of the edges.
bool overlap_in_plane(const Surface& a, const Surface& b, double diagonal)
{
    constexpr double rounding = 1e-7;   // of coordinates in a file, as a share of the scene
    constexpr double small_part = 1e-3; // share of the smaller surface
    const double size = std::sqrt(std::min(a.area(), b.area()));
    const double slack = std::min(rounding * diagonal, small_part * size);
    const FlatPolygon first = polygon_of(a);
    const FlatPolygon second = polygon_of(b);
    return !is_separated_from(first, cross(a.edge_u, a.edge_v), second, slack) &&
           !is_separated_from(second, cross(b.edge_u, b.edge_v), first, slack);
}

/// The surfaces sorted by plane.
struct Planes
{
    std::vector<std::uint32_t> surfaces;
    std::vector<std::uint32_t> begin; ///< offset of each plane in `surfaces`, and the end of the last one

    explicit Planes(const std::vector<std::uint32_t>& plane_number)
        : surfaces(plane_number.size()),
          begin(plane_number.empty() ? 2 : 2 + *std::max_element(plane_number.begin(), plane_number.end()))
    {
        for (const std::uint32_t plane : plane_number)
            ++begin[plane + 1];
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        std::vector<std::uint32_t> next = begin;
        for (std::uint32_t s = 0; s < plane_number.size(); ++s)
            surfaces[next[plane_number[s]]++] = s;
    }
};

} // namespace

PlaneNeighbours::PlaneNeighbours(const SurfaceList& surfaces, const LargeVector<Bounds>& boxes,
                                 const std::vector<std::uint32_t>& plane_number, const WideTree& tree,
                                 const FilterFrame& frame, int threads)
    : first_(surfaces.size(), empty_list)
{
    const Planes planes(plane_number);
    const auto find = [&](std::uint32_t s, std::size_t most_listed, std::vector<std::uint32_t>& found) {
        const auto take = [&](std::uint32_t other) {
            if (other != s && plane_number[other] == plane_number[s] && overlap(boxes[s], boxes[other]) &&
                overlap_in_plane(surfaces[s], surfaces[other], 2.0 * frame.radius()))
                found.push_back(other);
        };
        const std::uint32_t begin = planes.begin[plane_number[s]];
        const std::uint32_t end = planes.begin[plane_number[s] + 1];
        if (tree.empty() || end - begin <= few_in_plane) {
            std::for_each(planes.surfaces.begin() + begin, planes.surfaces.begin() + end, take);
            return true;
        }
        std::size_t looked_at = 0;
        tree.for_each_near({frame.to_frame(boxes[s].low), frame.to_frame(boxes[s].high)}, [&](std::uint32_t other) {
            take(other);
            return ++looked_at < most_looked_at && found.size() <= most_listed;
        });
        std::sort(found.begin(), found.end());
        return looked_at < most_looked_at && found.size() <= most_listed;
    };
    const auto neighbour = [&](std::uint32_t s) {
        const Vec3 low = frame.to_frame(boxes[s].low);
        const Vec3 high = frame.to_frame(boxes[s].high);
        const auto single = [](double x) { return static_cast<float>(x); };
        return Neighbour{
            s, {single(low.x), single(low.y), single(low.z)}, {single(high.x), single(high.y), single(high.z)}};
    };
    std::vector<std::vector<Neighbour>> lists((surfaces.size() + surfaces_at_a_time - 1) / surfaces_at_a_time);
    parallel_ranges(static_cast<std::uint32_t>(surfaces.size()), surfaces_at_a_time, threads,
                    [&](std::uint32_t first, std::uint32_t end) {
                        std::vector<Neighbour>& list = lists[first / surfaces_at_a_time];
                        std::vector<std::uint32_t> found;
                        for (std::uint32_t s = first; s < end; ++s) {
                            found.clear();
                            const std::size_t most_listed = list.size() > many_listed ? long_list : most_looked_at;
                            if (!find(s, most_listed, found)) {
                                first_[s] = unlisted;
                            } else if (!found.empty()) {
                                first_[s] = static_cast<std::uint32_t>(list.size() + 1);
                                std::transform(found.begin(), found.end(), std::back_inserter(list), neighbour);
                                list.push_back({end_of_list, {}, {}});
                            }
                        }
                    });
    for (std::size_t block = 0; block < lists.size(); ++block) {
        const auto before = static_cast<std::uint32_t>(neighbours_.size() - 1);
        const std::size_t end = std::min(surfaces.size(), (block + 1) * surfaces_at_a_time);
        for (std::size_t s = block * surfaces_at_a_time; s < end; ++s)
            first_[s] += first_[s] == empty_list || first_[s] == unlisted ? 0 : before;
        neighbours_.insert(neighbours_.end(), lists[block].begin(), lists[block].end());
    }
}

} // namespace multipath
