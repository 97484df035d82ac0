#pragma once

#include "base/mix_bits.h"
#include "geometry/vec3.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace multipath {

/// Points in a hash table of the cells of a regular grid.
class PointGrid
{
public:
    explicit PointGrid(double cell) : cell_(cell) {}

    double cell() const { return cell_; } ///< [scene units] edge of a cell

    /// Calls visit(point) for all points in the cells that overlap a box.
    template <class Visit>
    void visit_box(Vec3 low, Vec3 high, const Visit& visit) const
    {
        for (std::int64_t x = index(low.x); x <= index(high.x); ++x)
            for (std::int64_t y = index(low.y); y <= index(high.y); ++y)
                for (std::int64_t z = index(low.z); z <= index(high.z); ++z)
                    if (const auto found = points_.find(key(x, y, z)); found != points_.end())
                        for (const Vec3 point : found->second)
                            visit(point);
    }

    /// A point within `tolerance` [scene units], at most a cell, of a place, which is added as a point if there is
    /// none.
    Vec3 joined(Vec3 place, double tolerance)
    {
        const Vec3 margin = {tolerance, tolerance, tolerance};
        std::optional<Vec3> near;
        visit_box(place - margin, place + margin, [&](Vec3 point) {
            if (length(point - place) <= tolerance)
                near = point;
        });
        if (!near)
            points_[key(index(place.x), index(place.y), index(place.z))].push_back(place);
        return near.value_or(place);
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
    std::unordered_map<std::uint64_t, std::vector<Vec3>> points_;
};

} // namespace multipath
