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

/// For each surface the others in the same plane that overlap it, listed in advance: usually none. Surfaces that only
/// touch along their borders, as the triangles of a mesh do, do not overlap.
class PlaneNeighbours
{
public:
    PlaneNeighbours() = default;
    /// `boxes`: of the surfaces, with room for rounding. `tree`: over these boxes; where it is empty, or a plane has
    /// few surfaces, each is compared with each.
    PlaneNeighbours(const SurfaceList& surfaces, const LargeVector<Bounds>& boxes,
                    const std::vector<std::uint32_t>& plane_number, const WideTree& tree, const FilterFrame& frame,
                    int threads);

    /// False where so many surfaces lie together that looking for all of them would take too long.
    bool is_listed(std::uint32_t surface) const { return first_[surface] != unlisted; }

    /// False if the surface is listed and has none.
    bool may_have_some(std::uint32_t surface) const { return first_[surface] != empty_list; }

    /// Calls visit(other) for the neighbours of a listed surface whose boxes hold the point, in ascending order.
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
        std::uint32_t surface;
        float low[3], high[3]; ///< of its box, in the coordinates of the frame
    };

    std::vector<std::uint32_t> first_;                            ///< per surface: place of its list
    std::vector<Neighbour> neighbours_ = {{end_of_list, {}, {}}}; ///< all lists; the one at 0 is empty
};

} // namespace multipath
