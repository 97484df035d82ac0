#pragma once

#include "base/mix_bits.h"
#include "geometry/vec3.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace multipath {

/// Points with indices in a hash table of the cells of a regular grid.
class PointGrid
{
public:
    /// `cell`: edge of a cell [scene units]; `expected`: number of points to reserve memory for.
    PointGrid(double cell, std::size_t expected) : cell_(cell) { points_.reserve(expected); }

    void insert(Vec3 point, std::uint32_t number)
    {
        points_[key(index(point.x), index(point.y), index(point.z))].push_back(number);
    }

    /// Calls visit(number) for all points in the cells that overlap a box.
    template <class Visit>
    void visit_box(Vec3 low, Vec3 high, const Visit& visit) const
    {
        for (std::int64_t x = index(low.x); x <= index(high.x); ++x)
            for (std::int64_t y = index(low.y); y <= index(high.y); ++y)
                for (std::int64_t z = index(low.z); z <= index(high.z); ++z)
                    if (const auto found = points_.find(key(x, y, z)); found != points_.end())
                        for (const std::uint32_t number : found->second)
                            visit(number);
    }

    /// The smallest number of the points within `tolerance` [scene units], at most a cell, of a place;
    /// `position(number)` tells where they are.
    template <class Position>
    std::optional<std::uint32_t> first_near(Vec3 place, double tolerance, const Position& position) const
    {
        const Vec3 margin = {tolerance, tolerance, tolerance};
        std::optional<std::uint32_t> first;
        visit_box(place - margin, place + margin, [&](std::uint32_t number) {
            if (length(position(number) - place) <= tolerance)
                first = first ? std::min(*first, number) : number;
        });
        return first;
    }

private:
    std::int64_t index(double x) const { return static_cast<std::int64_t>(std::floor(x / cell_)); }
    static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z)
    {
        std::uint64_t bits = 0;
        for (const std::int64_t n : {x, y, z})
            bits = mix_bits(bits ^ static_cast<std::uint64_t>(n));
        return bits;
    }

    double cell_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> points_;
};

} // namespace multipath
