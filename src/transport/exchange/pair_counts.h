#pragma once

#include "base/archive.h"
#include "base/memory.h"
#include "parallel/run_control.h"
#include "sampling/sequence.h"
#include "scene/scene.h"
#include "transport/lines/global_lines.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

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

/// Numbers of lines that cross both patches of a pair, front facing front along the line.
struct PairCount
{
    std::uint32_t joined = 0;  ///< lines with no surface in between
    std::uint32_t through = 0; ///< all lines, with or without surfaces in between
};

/// Counts of global lines for every pair of patches. Sums of integers are exact, so the bits do not depend on how the
/// lines are divided, or in which order the counts are added.
struct PairCounts
{
    explicit PairCounts(std::uint32_t patches) : pairs(patches), escaped(patches, 0), behind(patches, 0) {}

    PairCounts& operator+=(const PairCounts& others); ///< needs counts of the same scene
    void visit(Archive& archive);                     ///< saves the counts to a checkpoint or restores them

    std::uint64_t lines = 0;            ///< global lines cast
    PairMatrix<PairCount> pairs;        ///< lines through each pair of patches
    std::vector<std::uint64_t> escaped; ///< per patch: lines that left its front, in either direction, and met nothing
    std::vector<std::uint64_t> behind;  ///< per patch: lines that left its front and next met a side without a patch
};

/// Casts global lines, line k with the item first_item + k for k = 0 ... lines_cast - 1, and counts the pairs of
/// patches along them. A shard (one of several runs that divide the work) casts only its part of the lines, a run that
/// is stopped casts fewer; PairCounts::lines is the number of lines that were cast. Needs lines_cast < 2^32, so that no
/// count can overflow.
PairCounts count_pairs(const Scene& scene, const GlobalLines& lines, const Sequence& sequence, std::uint64_t first_item,
                       std::uint64_t lines_cast, const RunControl& run);

} // namespace multipath
