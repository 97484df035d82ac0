#pragma once

#include "parallel/archive.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Sorts numbers below 2^bits; time grows like count * bits. Radix sort, with a second list of the same length.
void sort_keys(std::vector<std::uint64_t>& keys, int bits);

/// How many lines left one patch and reached another.
struct CountEntry
{
    std::uint32_t patch; ///< the one reached
    std::uint32_t count;
};

/// The patches that the lines from one patch reached, in order of their numbers.
struct CountRow
{
    const CountEntry* first;
    const CountEntry* last;

    const CountEntry* begin() const { return first; }
    const CountEntry* end() const { return last; }
};

/// Counts of the lines from a few patches, the rows, to all patches, the columns; only counts that are not zero take
/// memory. New lines wait in a list, 8 bytes each like a count, until they are sorted and merged.
class CountRows
{
public:
    CountRows(std::uint32_t rows, std::uint32_t columns);

    /// One line from the row to `end`, a patch or Segment::behind or Segment::outside.
    void add(std::uint32_t row, std::uint32_t end);
    void add(const CountRows& others); ///< of the same size, merged
    void merge();                      ///< afterwards, nothing waits
    void visit(Archive& archive);      ///< for a checkpoint; needs merged counts

    /// Needs merged counts.
    CountRow row(std::uint32_t row) const;
    std::uint64_t escaped(std::uint32_t row) const { return escaped_[row]; }
    std::uint64_t behind(std::uint32_t row) const { return behind_[row]; }

    std::uint64_t lines() const { return lines_; } ///< added so far, whatever they met
    std::size_t bytes() const;                     ///< in use, with what waits

private:
    std::uint32_t rows() const { return static_cast<std::uint32_t>(escaped_.size()); }

    int row_bits_;
    int column_bits_;
    std::vector<std::size_t> row_begin_; ///< one more than rows
    std::vector<CountEntry> entries_;
    std::vector<std::uint64_t> escaped_; ///< per row
    std::vector<std::uint64_t> behind_;  ///< per row
    std::vector<std::uint64_t> waiting_; ///< row << column_bits_ | column
    std::uint64_t lines_ = 0;
};

} // namespace multipath
