#pragma once

#include "sampling/sequence.h"
#include "scene/scene.h"
#include "transport/intersection_list.h"
#include "transport/line_sampling.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace multipath {

/// The global lines of a stage, cut into blocks.
struct LineBlocks
{
    const Scene& scene;
    const GlobalLines& global_lines;
    const Sequence& sequence;
    std::uint64_t first_item; ///< of the sequence, for the first line
    std::uint64_t lines;
    std::uint64_t block_lines; ///< in each block but the last

    std::uint64_t count() const { return (lines + block_lines - 1) / block_lines; }
    std::uint64_t lines_in(std::uint64_t blocks) const { return std::min(lines, blocks * block_lines); } ///< the first
};

/// How many lines make one piece of work for a thread: fewer than usual where they meet so many surfaces that a block
/// would fill the memory. `notes_per_line`: how many things a line leaves behind that are kept until its block is done.
inline std::uint64_t lines_per_block(double notes_per_line)
{
    constexpr double most_lines = 4096.0;
    constexpr double most_notes = 1u << 17;
    return static_cast<std::uint64_t>(std::clamp(most_notes / notes_per_line, 1.0, most_lines));
}

/// Successive global lines of a stage, as many as make one piece of work for a thread, with buffers that serve again.
class LineBlock
{
public:
    /// Takes block `number`: what each of its lines meets, in order.
    const HitLists& trace(const LineBlocks& blocks, std::uint64_t number)
    {
        const std::uint64_t first = number * blocks.block_lines;
        items_.resize(static_cast<std::size_t>(blocks.lines_in(number + 1) - first));
        lines_.resize(items_.size());
        blocks.sequence.generate(blocks.first_item + first, items_);
        blocks.global_lines.lines(items_.data(), items_.size(), lines_.data());
        blocks.scene.intersector().all_hits(lines_.data(), lines_.size(), hits_);
        return hits_;
    }

    std::uint64_t lines() const { return items_.size(); } ///< of the block traced last

private:
    std::vector<Item> items_;
    std::vector<Line> lines_;
    HitLists hits_;
};

/// The segments of a block of lines, in order.
struct SegmentBlock
{
    LineBlock lines;
    std::vector<Segment> segments;

    void trace(const LineBlocks& blocks, std::uint64_t number)
    {
        find_segments(blocks.scene, lines.trace(blocks, number), segments);
    }
};

} // namespace multipath
