#pragma once

#include "base/lists.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace multipath {

/// Disjoint sets of the numbers 0 ... count - 1: union-find with path halving (Tarjan and van Leeuwen 1984). Each set
/// is named by its least member.
class DisjointSets
{
public:
    explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

    std::uint32_t root(std::uint32_t a)
    {
        while (parent_[a] != a)
            a = parent_[a] = parent_[parent_[a]];
        return a;
    }
    void unite(std::uint32_t a, std::uint32_t b)
    {
        const std::pair<std::uint32_t, std::uint32_t> roots = std::minmax(root(a), root(b));
        parent_[roots.second] = roots.first;
    }
    /// The root of each number.
    std::vector<std::uint32_t> roots()
    {
        return serial_list(static_cast<std::uint32_t>(parent_.size()), [this](std::uint32_t a) { return root(a); });
    }

private:
    std::vector<std::uint32_t> parent_;
};

} // namespace multipath
