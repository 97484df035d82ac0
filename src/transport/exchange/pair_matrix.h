#pragma once

#include "parallel/archive.h"
#include "parallel/memory.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace multipath {

/// Symmetric matrix over n patches with one value for each unordered pair (i, j), i = j included. It stores the lower
/// triangle, row by row. All values are zero at first. Pages that were never written take no physical memory.
template <class Value>
class PairMatrix
{
public:
    explicit PairMatrix(std::uint32_t n) : n_(n), values_(pair_count(n)) {}

    std::uint32_t size() const { return n_; }

    Value& at(std::uint32_t i, std::uint32_t j) { return values_[index(i, j)]; }
    const Value& at(std::uint32_t i, std::uint32_t j) const { return values_[index(i, j)]; }

    /// The values of the pairs (i, 0), (i, 1), ..., (i, i). Those of the next rows follow in memory.
    Value* row(std::uint32_t i) { return values_.data() + pair_count(i); }
    const Value* row(std::uint32_t i) const { return values_.data() + pair_count(i); }

    /// Saves the values to a checkpoint or restores them. `Number` is the type of the numbers of which a Value
    /// consists. Throws ArchiveError if the checkpoint has a matrix of another size.
    template <class Number>
    void visit(Archive& archive, std::string_view name)
    {
        archive.list<Number>(name, values_);
    }

    /// Number of unordered pairs of n patches; also the index of the first value of row n.
    static std::size_t pair_count(std::uint32_t n) { return std::size_t{n} * (std::size_t{n} + 1) / 2; }
    /// Index of the pair (i, j) in the list of all values.
    static std::size_t index(std::uint32_t i, std::uint32_t j) { return i < j ? pair_count(j) + i : pair_count(i) + j; }

private:
    std::uint32_t n_;
    ZeroedVector<Value> values_;
};

} // namespace multipath
