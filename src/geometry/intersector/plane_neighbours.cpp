// Lists, for each surface, the coplanar surfaces that overlap it. The candidates of a list are all surfaces in the
// plane, if there are few, else those that the hierarchy has near the surface. Limits keep time and memory linear: a
// surface that exceeds a limit stays unlisted, and queries about this surface search the hierarchy.

#include "geometry/intersector/core.h"

#include "geometry/polygon.h"
#include "parallel/blocks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace multipath {

namespace {

constexpr std::uint32_t few_in_plane = 32;         ///< up to this number, all pairs in a plane are compared
constexpr std::size_t most_looked_at = 4096;       ///< limit of candidates for one surface
constexpr std::size_t most_listed = 256;           ///< limit of neighbours
constexpr std::uint32_t surfaces_at_a_time = 1024; ///< block of surfaces that one thread does at a time

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

} // namespace

PlaneNeighbours::PlaneNeighbours(const SurfaceList& surfaces, const LargeVector<Bounds>& boxes,
                                 const std::vector<std::uint32_t>& plane_number, const WideTree& tree,
                                 const FilterFrame& frame, int threads)
    : lists_(surfaces.size())
{
    std::vector<std::uint32_t> in_plane(surfaces.size()); // number of surfaces in each plane
    std::vector<std::uint32_t> last(surfaces.size());     // the last one of them
    std::vector<std::uint32_t> before(surfaces.size());   // of each surface: the one before it in the same plane
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        before[s] = std::exchange(last[plane_number[s]], s);
        ++in_plane[plane_number[s]];
    }
    const auto find = [&](std::uint32_t s, std::vector<std::uint32_t>& found) {
        const auto take = [&](std::uint32_t other) {
            if (other != s && plane_number[other] == plane_number[s] && overlap(boxes[s], boxes[other]) &&
                overlap_in_plane(surfaces[s], surfaces[other], 2.0 * frame.radius()))
                found.push_back(other);
        };
        std::size_t looked_at = 0;
        if (tree.empty() || in_plane[plane_number[s]] <= few_in_plane) {
            for (std::uint32_t other = last[plane_number[s]]; looked_at < in_plane[plane_number[s]]; ++looked_at) {
                take(other);
                other = before[other];
            }
            std::reverse(found.begin(), found.end());
            return true;
        }
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
    parallel_ranges(static_cast<std::uint32_t>(surfaces.size()), surfaces_at_a_time, threads,
                    [&](std::uint32_t first, std::uint32_t end) {
                        std::vector<std::uint32_t> found;
                        for (std::uint32_t s = first; s < end; ++s) {
                            found.clear();
                            if (find(s, found))
                                std::transform(found.begin(), found.end(), std::back_inserter(lists_[s]), neighbour);
                            else
                                lists_[s] = {{unlisted, {}, {}}};
                        }
                    });
}

} // namespace multipath
