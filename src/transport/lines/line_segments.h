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

/// A stretch of a line between two surfaces that follow each other along it, or from the last one to infinity.
/// `from` is the patch that the stretch leaves, `to` the patch that it reaches, each with the side that looks along
/// the stretch. One of the two may be `behind` (a surface that has no patch on this side) or `outside` (nothing).
struct Segment
{
    static constexpr std::uint32_t behind = 0xfffffffeu;
    static constexpr std::uint32_t outside = 0xffffffffu;

    std::uint32_t from;
    std::uint32_t to;

    static bool is_patch(std::uint32_t end) { return end < behind; }
    /// The facing pair of the paper: both ends can exchange power.
    bool joins_patches() const { return is_patch(from) && is_patch(to); }
};

/// What a line meets at one surface: the patch on the side where it arrives and the one on the side where it goes on,
/// or Segment::behind where the side has none.
struct Passage
{
    std::uint32_t arrives_at;
    std::uint32_t leaves;
};

Passage passage_at(const Scene& scene, const Hit& hit);

/// One passage for every hit of many lines, line after line. Replaces what `passages` held.
void find_passages(const Scene& scene, const HitLists& lists, std::vector<Passage>& passages);

/// Appends the segments of one line, given its hits in order. Those that touch no patch are left out.
void append_segments(const Scene& scene, HitLists::List hits, std::vector<Segment>& segments);

/// The segments of many lines, line after line. Replaces what `segments` held.
void find_segments(const Scene& scene, const HitLists& lists, std::vector<Segment>& segments);

/// The global lines of a stage, cut into blocks.
struct LineBlocks
{
    const Scene& scene;
    const GlobalLines& global_lines;
    const Sequence& sequence;
    std::uint64_t first_item; ///< of the sequence, for the first line
    Blocks lines;
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
        items_.resize(blocks.lines.length(number));
        lines_.resize(items_.size());
        blocks.sequence.generate(blocks.first_item + blocks.lines.first(number), items_);
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
