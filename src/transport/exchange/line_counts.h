#pragma once

#include "base/archive.h"
#include "parallel/run_control.h"
#include "sampling/allotment.h"
#include "sampling/sequence.h"
#include "scene/scene.h"
#include "transport/lines/line_segments.h"
#include "transport/lines/local_rays.h"

#include <cstdint>
#include <deque>
#include <mutex>
#include <vector>

namespace multipath {

/// Sorts keys below 2^bits in ascending order by radix sort, in time proportional to count * bits and with a second
/// list of the same length. Fewer than 512 keys, or 2^32 and more, are sorted by std::sort.
void sort_keys(std::vector<std::uint64_t>& keys, int bits);

/// The patches that the lines from one patch reached, in ascending order. A patch that was reached n times occurs n
/// times.
struct CountRow
{
    const std::uint32_t* first;
    const std::uint32_t* last;

    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
};

/// Counts of lines from a few patches, the rows, to all patches, the columns. A line between patches takes 4 bytes, a
/// line that escaped or met a back none. New lines are appended to an unsorted list, 8 bytes each, which merge() sorts
/// into the counts.
class CountRows
{
public:
    CountRows(std::uint32_t rows, std::uint32_t columns);

    /// Adds one line from the patch of a row to `end`: a patch, Segment::behind or Segment::outside.
    void add(std::uint32_t row, std::uint32_t end);
    /// Adds merged counts of the same size. The unsorted lines of this object stay unsorted.
    void add(const CountRows& others);
    /// Sorts all new lines into the counts.
    void merge();
    /// Saves merged counts to a checkpoint or restores them. Throws ArchiveError for damaged rows, or those of another
    /// size.
    void visit(Archive& archive);

    /// Lines that merge() has not sorted yet are missing.
    CountRow row(std::uint32_t row) const
    {
        return {reached_.data() + row_begin_[row], reached_.data() + row_begin_[row + 1]};
    }
    std::uint64_t escaped(std::uint32_t row) const { return escaped_[row]; }
    std::uint64_t behind(std::uint32_t row) const { return behind_[row]; }

private:
    std::uint32_t rows() const { return static_cast<std::uint32_t>(escaped_.size()); }

    int row_bits_;    ///< number of bits of a row in a key
    int column_bits_; ///< number of bits of a column in a key
    /// Offset of each row in reached_; one more entry holds the size of reached_.
    std::vector<std::uint64_t> row_begin_;
    std::vector<std::uint32_t> reached_;  ///< columns, row after row, in ascending order within a row
    std::vector<std::uint64_t> escaped_;  ///< per row: lines that left the scene
    std::vector<std::uint64_t> behind_;   ///< per row: lines that met a side without a patch
    std::vector<std::uint64_t> unsorted_; ///< new lines: row << column_bits_ | column
};

/// Sparse counts of how often lines joined each pair of patches, escaped, or met a side without a patch: for scenes
/// with so many patches that most pairs are never joined. The counts depend only on the set of the segments (Segment),
/// not on their order, on threads, or on how the lines were divided; so counts of parts of the lines add up to the same
/// bits. Needs fewer than 2^32 lines in total, and no line may join a patch with itself.
class LineCounts
{
public:
    explicit LineCounts(std::uint32_t patches);

    /// Counts each segment in the rows of both of its ends. Thread-safe.
    void add(const std::vector<Segment>& segments);

    /// Sorts the new segments into the counts. Neither merge() nor any function below may run while a thread adds, and
    /// the functions below need merged counts.
    void merge(int threads);
    /// Adds the counts of another object of the same size, and frees the memory of `others` on the way.
    void add(LineCounts others, int threads);
    /// Saves the counts to a checkpoint or restores them. Throws ArchiveError for damaged counts.
    void visit(Archive& archive);

    std::uint32_t size() const { return patches_; } ///< number of patches
    CountRow row(std::uint32_t patch) const { return part(patch).row(row_in_part(patch)); }
    std::uint64_t escaped(std::uint32_t patch) const { return part(patch).escaped(row_in_part(patch)); }
    std::uint64_t behind(std::uint32_t patch) const { return part(patch).behind(row_in_part(patch)); }

private:
    /// The rows of 2^part_bits_ consecutive patches; the last part may have fewer.
    struct Part
    {
        Part(std::uint32_t rows, std::uint32_t columns) : counts(rows, columns) {}
        std::mutex mutex; ///< guards the counts while segments are added
        CountRows counts;
    };
    const CountRows& part(std::uint32_t patch) const { return parts_[patch >> part_bits_].counts; }
    std::uint32_t row_in_part(std::uint32_t patch) const { return patch & ((1u << part_bits_) - 1); }

    std::uint32_t patches_;
    int part_bits_; ///< log2 of the patches per part
    std::deque<Part> parts_;
};

/// The division of the allotted rays into blocks, the units of work of count_rays.
inline Blocks ray_blocks(const Allotment& rays)
{
    return {rays.rays(), rays_per_block};
}

/// Casts the allotted rays (local_lines) of the blocks range.next ... range.end - 1 of ray_blocks(), and counts them;
/// those that reach the sky count as escaped. A run that is stopped casts the rays of fewer blocks, from the beginning
/// of the range. Moves range.next past the blocks done, and leaves the counts merged. Ray n of the allotment takes the
/// item first_item + n of the sequence.
void count_rays(const Scene& scene, const Allotment& rays, const Sequence& sequence, std::uint64_t first_item,
                ShardRange& range, const RunControl& run, LineCounts& counts);

} // namespace multipath
