#pragma once

#include "geometry/bounds.h"
#include "geometry/conditions.h"
#include "geometry/intersector/filter_line.h"
#include "geometry/intersector/tree.h"
#include "geometry/surface.h"
#include "parallel/memory.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Precomputed lists: for each surface, its neighbours, the other surfaces in the same plane that overlap it. Most
/// lists are empty. Surfaces that only touch along their borders, like the triangles of a mesh, do not overlap.
class PlaneNeighbours
{
public:
    PlaneNeighbours() = default;
    /// `boxes`: the result of boxes_around_each. `plane_number`: SharedPlanes::plane_number. `tree`: hierarchy over the
    /// boxes, in the coordinates of `frame`. If the tree is empty or a plane has few surfaces, all pairs in the plane
    /// are compared.
    PlaneNeighbours(const SurfaceList& surfaces, const LargeVector<Bounds>& boxes,
                    const std::vector<std::uint32_t>& plane_number, const WideTree& tree, const FilterFrame& frame,
                    int threads);

    /// True if the surface has a list. Without a tree every surface has one; with a tree, a surface near too many
    /// others has none.
    bool is_listed(std::uint32_t surface) const { return first_[surface] != unlisted; }

    /// False if the surface certainly has no neighbour: its list exists and is empty. True for an unlisted surface.
    bool may_have_some(std::uint32_t surface) const { return first_[surface] != empty_list; }

    /// Calls visit(other) for those neighbours of a listed surface whose boxes contain the point, in ascending order.
    template <class Visit>
    void for_each_around(std::uint32_t surface, Vec3 point_in_frame, const Visit& visit) const
    {
        const auto x = static_cast<float>(point_in_frame.x);
        const auto y = static_cast<float>(point_in_frame.y);
        const auto z = static_cast<float>(point_in_frame.z);
        for (const Neighbour* other = &neighbours_[first_[surface]]; other->surface != end_of_list; ++other)
            if (every(other->low[0] <= x, x <= other->high[0], other->low[1] <= y, y <= other->high[1],
                      other->low[2] <= z, z <= other->high[2]))
                visit(other->surface);
    }

private:
    static constexpr std::uint32_t unlisted = 0xffffffffu;
    static constexpr std::uint32_t empty_list = 0;
    static constexpr std::uint32_t end_of_list = 0xffffffffu;

    struct Neighbour
    {
        std::uint32_t surface; ///< end_of_list after the last neighbour of each list
        float low[3], high[3]; ///< box of the surface, in the frame
    };

    std::vector<std::uint32_t> first_;                            ///< per surface: offset of its list, or unlisted
    std::vector<Neighbour> neighbours_ = {{end_of_list, {}, {}}}; ///< all lists; the list at 0 is empty
};

} // namespace multipath
