#pragma once

#include "sampling/sequence.h"
#include "scene/scene.h"
#include "transport/intersection_list.h"
#include "transport/line_sampling.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace multipath {

/// Successive global lines of a stage, as many as make one piece of work for a thread, with buffers that serve again.
class LineBlock
{
public:
    static constexpr std::uint64_t most_lines = 4096;

    static std::uint64_t blocks_for(std::uint64_t lines) { return (lines + most_lines - 1) / most_lines; }

    /// Takes block `number` of the `lines` lines whose items begin at first_item: what each of them meets, in order.
    const HitLists& trace(const Scene& scene, const GlobalLines& global_lines, const Sequence& sequence,
                          std::uint64_t first_item, std::uint64_t lines, std::uint64_t number)
    {
        const std::uint64_t first = number * most_lines;
        items_.resize(static_cast<std::size_t>(std::min(most_lines, lines - first)));
        lines_.resize(items_.size());
        sequence.generate(first_item + first, items_);
        global_lines.lines(items_.data(), items_.size(), lines_.data());
        scene.intersector().all_hits(lines_.data(), lines_.size(), hits_);
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

    void trace(const Scene& scene, const GlobalLines& global_lines, const Sequence& sequence, std::uint64_t first_item,
               std::uint64_t line_count, std::uint64_t number)
    {
        find_segments(scene, lines.trace(scene, global_lines, sequence, first_item, line_count, number), segments);
    }
};

} // namespace multipath
