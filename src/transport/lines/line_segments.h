#pragma once

#include "geometry/intersector/intersector.h"
#include "parallel/blocks.h"
#include "sampling/sequence.h"
#include "scene/scene.h"
#include "transport/lines/global_lines.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace multipath {

/// The part of a line between two successive surfaces along it, before the first, or after the last surface. `from` is
/// the patch that the segment leaves, `to` the patch that it reaches, both on the sides of the surfaces that face the
/// segment. Instead of a patch, an end is `behind` if its surface has no patch on that side (a back), and `outside` if
/// there is no surface.
struct Segment
{
    static constexpr std::uint32_t behind = 0xfffffffeu;
    static constexpr std::uint32_t outside = 0xffffffffu;

    std::uint32_t from; ///< patch, `behind` or `outside`
    std::uint32_t to;   ///< patch, `behind` or `outside`

    static bool is_patch(std::uint32_t end) { return end < behind; }
    /// True if both ends are patches, which the segment joins; they exchange power along it.
    bool joins_patches() const { return is_patch(from) && is_patch(to); }
};

/// The patches on the two sides of a surface at a hit. Segment::behind stands for a side without a patch.
struct Passage
{
    std::uint32_t arrives_at; ///< patch on the side from which the line comes
    std::uint32_t leaves;     ///< patch on the side on which the line goes on
};

Passage passage_at(const Scene& scene, const Hit& hit);

/// Appends the segments of one line in order, given its hits in order. Segments that touch no patch are left out.
void append_segments(const Scene& scene, HitLists::List hits, std::vector<Segment>& segments);

/// Finds the segments of many lines like append_segments, line after line. Replaces the contents of `segments`.
void find_segments(const Scene& scene, const HitLists& lists, std::vector<Segment>& segments);

/// The global lines of one stage of a run, divided into blocks.
struct LineBlocks
{
    const Scene& scene;
    const GlobalLines& global_lines;
    const Sequence& sequence;
    std::uint64_t first_item; ///< line k takes item (point) first_item + k of the sequence
    Blocks lines;             ///< number of lines, and lines per block
};

/// Number of lines in a block: 4096, or fewer (at least 1) if a block would need too much memory. `records_per_line` is
/// the mean number of records per line that are stored until the block is done.
inline std::uint64_t lines_per_block(double records_per_line)
{
    constexpr double most_lines = 4096.0;
    constexpr double most_records = 1u << 17;
    return static_cast<std::uint64_t>(std::clamp(most_records / records_per_line, 1.0, most_lines));
}

/// Traces one block of global lines at a time, in reusable buffers.
class LineBlock
{
public:
    /// Traces block `number`. Returns the hits of its lines, in the order of the lines; they are valid until the next
    /// call.
    const HitLists& trace(const LineBlocks& blocks, std::uint64_t number)
    {
        items_.resize(blocks.lines.length(number));
        lines_.resize(items_.size());
        blocks.sequence.generate(blocks.first_item + blocks.lines.first(number), items_);
        blocks.global_lines.lines(items_.data(), items_.size(), lines_.data());
        blocks.scene.intersector().all_hits(lines_.data(), lines_.size(), hits_);
        return hits_;
    }

private:
    std::vector<Item> items_;
    std::vector<Line> lines_;
    HitLists hits_;
};

/// The segments of a block of global lines, in order, in reusable buffers.
struct SegmentBlock
{
    LineBlock lines;
    std::vector<Segment> segments;

    /// Traces block `number` and sets `segments`.
    void trace(const LineBlocks& blocks, std::uint64_t number)
    {
        find_segments(blocks.scene, lines.trace(blocks, number), segments);
    }
};

} // namespace multipath
