#pragma once

#include "geometry/bounds.h"
#include "geometry/intersector/shared_planes.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// For each surface the others in the same plane that may touch it, listed in advance: usually none.
class PlaneNeighbours
{
public:
    /// Planes of more surfaces than this are not listed: comparing each with each would take too long.
    static constexpr std::size_t most_in_plane = 96;

    PlaneNeighbours() = default;
    /// `boxes`: of the surfaces, with room for rounding.
    PlaneNeighbours(const LargeVector<Bounds>& boxes, const std::vector<std::uint32_t>& plane_number);

    bool is_listed(std::uint32_t surface) const { return first_[surface] != unlisted; }

    /// False if the surface is listed and has none.
    bool may_have_some(std::uint32_t surface) const { return first_[surface] != empty_list; }

    /// Calls visit(other) for the neighbours of a listed surface, in ascending order.
    template <class Visit>
    void for_each(std::uint32_t surface, const Visit& visit) const
    {
        for (std::uint32_t i = first_[surface]; neighbours_[i] != end_of_list; ++i)
            visit(neighbours_[i]);
    }

private:
    static constexpr std::uint32_t unlisted = 0xffffffffu;
    static constexpr std::uint32_t empty_list = 0;
    static constexpr std::uint32_t end_of_list = 0xffffffffu;

    std::vector<std::uint32_t> first_;                      ///< per surface: place of its list
    std::vector<std::uint32_t> neighbours_ = {end_of_list}; ///< all lists; the one at 0 is empty
};

} // namespace multipath
