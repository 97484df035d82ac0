#include "export/point_grid.h"

#include "sampling/random.h"

#include <cmath>

namespace multipath {

PointGrid::PointGrid(double cell, std::size_t expected) : cell_(cell)
{
    std::size_t buckets = 16;
    while (buckets < expected)
        buckets *= 2;
    heads_.assign(buckets, none);
    entries_.reserve(expected);
}

void PointGrid::insert(Vec3 point, std::uint32_t number)
{
    std::uint32_t& head = heads_[bucket(index(point.x), index(point.y), index(point.z))];
    entries_.push_back({number, head});
    head = static_cast<std::uint32_t>(entries_.size() - 1);
}

std::int64_t PointGrid::index(double x) const
{
    return static_cast<std::int64_t>(std::floor(x / cell_));
}

std::size_t PointGrid::bucket(std::int64_t x, std::int64_t y, std::int64_t z) const
{
    std::uint64_t bits = 0;
    for (const std::int64_t n : {x, y, z})
        bits = mix_bits(bits ^ static_cast<std::uint64_t>(n));
    return static_cast<std::size_t>(bits) & (heads_.size() - 1);
}

} // namespace multipath
