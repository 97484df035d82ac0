#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace multipath {

/// One value for each unordered pair of n patches, a patch with itself included: the lower triangle, row by row.
template <class Value>
class PairMatrix
{
public:
    explicit PairMatrix(std::uint32_t n) : n_(n), values_(pair_count(n)) {}

    std::uint32_t size() const { return n_; }

    Value& at(std::uint32_t i, std::uint32_t j) { return values_[index(i, j)]; }
    const Value& at(std::uint32_t i, std::uint32_t j) const { return values_[index(i, j)]; }

    /// The pairs (i, 0), (i, 1) ... (i, i).
    Value* row(std::uint32_t i) { return values_.data() + pair_count(i); }
    const Value* row(std::uint32_t i) const { return values_.data() + pair_count(i); }

    static std::size_t pair_count(std::uint32_t n) { return std::size_t{n} * (std::size_t{n} + 1) / 2; }
    static std::size_t index(std::uint32_t i, std::uint32_t j) { return i < j ? pair_count(j) + i : pair_count(i) + j; }

private:
    std::uint32_t n_;
    std::vector<Value> values_;
};

} // namespace multipath
