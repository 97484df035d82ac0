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

/// Sorts numbers below 2^bits; time grows like count * bits. Radix sort, with a second list of the same length.
void sort_keys(std::vector<std::uint64_t>& keys, int bits);

/// The patches that the lines from one patch reached, in order of their numbers, each as often as it was reached.
struct CountRow
{
    const std::uint32_t* first;
    const std::uint32_t* last;

    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
};

/// Counts of the lines from a few patches, the rows, to all patches, the columns: 4 bytes for each line. New lines wait
/// in a list, 8 bytes each, until they are sorted and merged.
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

private:
    std::uint32_t rows() const { return static_cast<std::uint32_t>(escaped_.size()); }

    int row_bits_;
    int column_bits_;
    std::vector<std::uint64_t> row_begin_; ///< one more than rows
    std::vector<std::uint32_t> reached_;   ///< row after row
    std::vector<std::uint64_t> escaped_;   ///< per row
    std::vector<std::uint64_t> behind_;    ///< per row
    std::vector<std::uint64_t> waiting_;   ///< row << column_bits_ | column
};

/// How often lines joined any two patches, escaped or met a surface from behind: for scenes with so many patches that
/// most pairs are never joined. A function of the segments added, in whatever order, parts and threads; so counts of
/// parts of the lines add up to the same bits. Needs fewer than 2^32 lines in all, and that no line joins a patch with
/// itself.
class LineCounts
{
public:
    explicit LineCounts(std::uint32_t patches);

    /// Notes each segment for both of its ends. Several threads may call it at the same time.
    void add(const std::vector<Segment>& segments);

    /// Takes in all that was added. What follows needs this first, and that no thread adds.
    void merge(int threads);
    /// Both must be merged and of the same size. The memory of the others is given back on the way.
    void add(LineCounts others, int threads);
    void visit(Archive& archive); ///< for a checkpoint

    std::uint32_t size() const { return patches_; }
    CountRow row(std::uint32_t patch) const { return part(patch).row(place(patch)); }
    std::uint64_t escaped(std::uint32_t patch) const { return part(patch).escaped(place(patch)); }
    std::uint64_t behind(std::uint32_t patch) const { return part(patch).behind(place(patch)); }

private:
    /// Consecutive patches; their number is a power of two.
    struct Part
    {
        Part(std::uint32_t rows, std::uint32_t columns) : counts(rows, columns) {}
        std::mutex mutex; ///< guards the counts while segments are added
        CountRows counts;
    };
    struct LineEnd
    {
        std::uint32_t patch;
        std::uint32_t other;
    };

    static std::vector<LineEnd> line_ends(const std::vector<Segment>& segments);
    const CountRows& part(std::uint32_t patch) const { return parts_[patch >> part_bits_].counts; }
    std::uint32_t place(std::uint32_t patch) const { return patch & ((1u << part_bits_) - 1); }
    void add(const LineEnd* first, const LineEnd* last, Part& part) const;

    std::uint32_t patches_;
    int part_bits_;
    std::deque<Part> parts_;
};

/// The blocks of rays in which `count_rays` works.
Blocks ray_blocks(const Allotment& rays);

/// Casts the allotted rays, uniform on the patches and cosine-distributed (LocalRays), of the blocks range.next ...
/// range.end - 1, or of fewer if the run is stopped, and adds what they join to the counts; merged afterwards. Ray
/// number n takes the item first_item + n.
void count_rays(const Scene& scene, const Allotment& rays, const Sequence& sequence, std::uint64_t first_item,
                SharedRange& range, const RunControl& run, LineCounts& counts);

} // namespace multipath
