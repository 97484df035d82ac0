#pragma once

#include "parallel/archive.h"
#include "parallel/run_control.h"
#include "sampling/allotment.h"
#include "sampling/sequence.h"
#include "scene/scene.h"
#include "transport/lines/global_lines.h"
#include "transport/lines/line_segments.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <vector>

namespace multipath {

/// Sorts keys below 2^bits by radix sort, in time proportional to count * bits, with a second list of the same length.
void sort_keys(std::vector<std::uint64_t>& keys, int bits);

/// The patches that the lines from one patch reached, sorted, each repeated as often as it was reached.
struct CountRow
{
    const std::uint32_t* first;
    const std::uint32_t* last;

    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
};

/// Counts of lines from a few patches, the rows, to all patches, the columns. A counted line takes 4 bytes. New lines
/// are appended to an unsorted list, 8 bytes each, which merge() sorts into the counts.
class CountRows
{
public:
    CountRows(std::uint32_t rows, std::uint32_t columns);

    /// Adds one line from the row to `end`: a patch, Segment::behind or Segment::outside.
    void add(std::uint32_t row, std::uint32_t end);
    /// Adds merged counts of the same size. This object's own unsorted lines stay unsorted.
    void add(const CountRows& others);
    /// Sorts all new lines into the counts.
    void merge();
    /// Saves or restores merged counts. Throws ArchiveError for damaged rows.
    void visit(Archive& archive);

    CountRow row(std::uint32_t row) const; ///< needs merged counts
    std::uint64_t escaped(std::uint32_t row) const { return escaped_[row]; }
    std::uint64_t behind(std::uint32_t row) const { return behind_[row]; }

private:
    std::uint32_t rows() const { return static_cast<std::uint32_t>(escaped_.size()); }

    int row_bits_;
    int column_bits_;
    std::vector<std::uint64_t> row_begin_; ///< offset of each row in reached_; then their total
    std::vector<std::uint32_t> reached_;   ///< columns, row after row, sorted in each
    std::vector<std::uint64_t> escaped_;   ///< per row
    std::vector<std::uint64_t> behind_;    ///< per row
    std::vector<std::uint64_t> unsorted_;  ///< new lines: row << column_bits_ | column
};

/// Sparse counts of how often lines joined each pair of patches, escaped, or met a surface from behind: for scenes with
/// so many patches that most pairs are never joined. The counts depend on the set of segments only, not on order,
/// threads or how they were split, so counts of parts of the lines add up to the same bits. Needs fewer than 2^32 lines
/// in total, and no line may join a patch with itself.
class LineCounts
{
public:
    explicit LineCounts(std::uint32_t patches);

    /// Counts each segment in the rows of both of its ends. Thread-safe.
    void add(const std::vector<Segment>& segments);

    /// Sorts the new segments into the counts. All functions below need merged counts, and that no other thread adds.
    void merge(int threads);
    /// Adds the counts of another object of the same size, both merged, and frees the memory of `others` on the way.
    void add(LineCounts others, int threads);
    void visit(Archive& archive); ///< saves to or restores from a checkpoint; throws ArchiveError for damaged counts

    std::uint32_t size() const { return patches_; }
    CountRow row(std::uint32_t patch) const { return part(patch).row(row_in_part(patch)); }
    std::uint64_t escaped(std::uint32_t patch) const { return part(patch).escaped(row_in_part(patch)); }
    std::uint64_t behind(std::uint32_t patch) const { return part(patch).behind(row_in_part(patch)); }

private:
    /// The rows of consecutive patches. Their number is a power of two, but for the last part.
    struct Part
    {
        Part(std::uint32_t rows, std::uint32_t columns) : counts(rows, columns) {}
        std::mutex mutex; ///< guards the counts while segments are added
        CountRows counts;
    };
    /// A segment as its end `patch` counts it; `other` is the opposite end.
    struct LineEnd
    {
        std::uint32_t patch;
        std::uint32_t other;
    };

    static std::vector<LineEnd> line_ends(const std::vector<Segment>& segments);
    const CountRows& part(std::uint32_t patch) const { return parts_[patch >> part_bits_].counts; }
    std::uint32_t row_in_part(std::uint32_t patch) const { return patch & ((1u << part_bits_) - 1); }
    void add(const LineEnd* first, const LineEnd* last, Part& part) const;

    std::uint32_t patches_;
    int part_bits_; ///< log2 of the patches per part
    std::deque<Part> parts_;
};

/// The blocks of rays that count_rays processes at a time.
Blocks ray_blocks(const Allotment& rays);

/// Casts the allotted rays (LocalRays) of the blocks range.next ... range.end - 1 of ray_blocks, or of fewer if the run
/// is stopped, and counts them. Moves range.next past the blocks done, and leaves the counts merged. Ray n takes the
/// item first_item + n.
void count_rays(const Scene& scene, const Allotment& rays, const Sequence& sequence, std::uint64_t first_item,
                ShardRange& range, const RunControl& run, LineCounts& counts);

} // namespace multipath
