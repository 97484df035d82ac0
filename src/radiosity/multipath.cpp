#include "radiosity/multipath.h"

#include "parallel/ordered_blocks.h"
#include "radiosity/power_walk.h"

#include <algorithm>

namespace multipath {

namespace {

constexpr std::uint64_t lines_per_block = 4096;

/// Buffers of one block of lines between tracing and exchange.
struct LineBlock
{
    std::vector<Item> items;
    std::vector<Hit> hits;
    std::vector<Segment> segments;
};

void trace(const Scene& scene, const GlobalLines& lines, LineBlock& block)
{
    block.segments.clear();
    for (const Item& item : block.items) {
        scene.intersector().all_hits(lines.line(item), block.hits);
        append_segments(scene, block.hits, block.segments);
    }
}

} // namespace

void cast_global_lines(const Scene& scene, const GlobalLines& lines, const Sequence& sequence, const GlobalPass& pass,
                       int threads, PowerState& state, const LineCounter& count_lines)
{
    if (pass.lines_cast == 0)
        return;
    PowerWalk walk(scene, lines.expected_crossings(1.0, pass.lines_cast), pass.bidirectional, state); // (G1)
    WalkTally total;
    std::vector<LineBlock> blocks(static_cast<std::size_t>(slot_count(threads)));
    const auto produce = [&](std::uint64_t number, int slot) {
        LineBlock& block = blocks[static_cast<std::size_t>(slot)];
        const std::uint64_t first = number * lines_per_block;
        block.items.resize(static_cast<std::size_t>(std::min(lines_per_block, pass.lines_cast - first)));
        sequence.generate(pass.first_item + first, block.items);
        trace(scene, lines, block);
    };
    const auto exchange_in_order = [&](std::uint64_t, int slot) {
        const LineBlock& block = blocks[static_cast<std::size_t>(slot)];
        WalkTally tally; // sums of one block stay small, which keeps the rounding errors of the balance small
        for (const Segment& segment : block.segments)
            walk.follow(segment, tally);
        total += tally;
        count_lines(block.items.size());
    };
    ordered_blocks((pass.lines_cast + lines_per_block - 1) / lines_per_block, threads, produce, exchange_in_order);
    walk.finish(total, state);
}

} // namespace multipath
