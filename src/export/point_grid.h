#pragma once

#include "geometry/vec3.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Numbered points by where they are: in cells of a regular grid, of which only those in use take memory.
class PointGrid
{
public:
    /// The edge of a cell and how many points to expect; more make it slower.
    PointGrid(double cell, std::size_t expected);

    void insert(Vec3 point, std::uint32_t number);

    /// Calls visit(number) for all points in a box, and for others that it does not keep apart; some perhaps twice.
    template <class Visit>
    void visit_box(Vec3 low, Vec3 high, const Visit& visit) const
    {
        for (std::int64_t x = index(low.x); x <= index(high.x); ++x)
            for (std::int64_t y = index(low.y); y <= index(high.y); ++y)
                for (std::int64_t z = index(low.z); z <= index(high.z); ++z)
                    for (std::uint32_t entry = heads_[bucket(x, y, z)]; entry != none; entry = entries_[entry].next)
                        visit(entries_[entry].number);
    }

private:
    struct Entry
    {
        std::uint32_t number;
        std::uint32_t next; ///< in the same bucket
    };
    static constexpr std::uint32_t none = 0xffffffffu;

    std::int64_t index(double x) const;
    std::size_t bucket(std::int64_t x, std::int64_t y, std::int64_t z) const;

    double cell_;
    std::vector<std::uint32_t> heads_; ///< per bucket, which cells share by chance; their number is a power of two
    std::vector<Entry> entries_;
};

} // namespace multipath
