// The multi-path method. A global line crosses the whole scene and meets many patches. Every pair of patches that face
// each other along it exchanges power, in both directions at once, so that one line carries a piece of many light
// paths.
//
// A patch sends two things along each line that leaves its front: everything that it received and reflected since it
// sent last, which it then no longer holds (M1), and an equal share of what was unshot when the pass began, the
// forecast (G3). No cosine and no 1/r^2 appear anywhere: the density of the lines contains both (G1).

#include "radiosity/multipath.h"

#include "parallel/ordered_blocks.h"
#include "radiosity/intersection_list.h"

#include <algorithm>

namespace multipath {

namespace {

constexpr std::uint64_t lines_per_block = 4096;

/// What an exchange touches of a patch, side by side in memory.
struct WalkingPower
{
    Rgb reflectance;
    Rgb forecast; ///< [W] sent by every line (G3)
    Rgb held;     ///< [W] reflected, to be sent by the next line
    Rgb incident; ///< [W] arrived in this pass

    Rgb to_send() const { return forecast + held; }
    void receive(Rgb power)
    {
        incident += power;
        held = reflectance * power;
    }
};

/// Power that the lines of one block sent, and what of it no patch received [W].
struct BlockTally
{
    Rgb forecast_sent;
    Rgb escaped;
    Rgb behind;
};

class Walk
{
public:
    Walk(const Scene& scene, const GlobalLines& lines, const GlobalPass& pass, const PowerState& state)
        : bidirectional_(pass.bidirectional)
    {
        patches_.reserve(scene.patch_count());
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const double crossings = lines.expected_crossings(scene.area(i), pass.lines_cast); // (G1)
            const double departures = bidirectional_ ? crossings : 0.5 * crossings; // half of them leave the front
            patches_.push_back({scene.reflectance(i), (1.0 / departures) * state.unshot[i], {}, {}}); // (G3)
        }
    }

    void follow(const Segment& segment, BlockTally& tally)
    {
        if (segment.joins_patches())
            exchange(patches_[segment.from], patches_[segment.to], tally);
        else if (Segment::is_patch(segment.from))
            lose(patches_[segment.from], segment.to, tally);
        else if (bidirectional_)
            lose(patches_[segment.to], segment.from, tally);
    }

    /// Adds what the pass distributed; what the patches hold is what is left unshot.
    void finish(const BlockTally& total, PowerState& state) const
    {
        for (std::size_t i = 0; i < patches_.size(); ++i) {
            state.emitted = state.emitted - state.unshot[i];
            state.incident[i] += patches_[i].incident;
            state.unshot[i] = patches_[i].held;
        }
        state.emitted += total.forecast_sent;
        state.escaped += total.escaped;
        state.behind += total.behind;
    }

private:
    void exchange(WalkingPower& i, WalkingPower& j, BlockTally& tally) const
    {
        const Rgb sent_by_i = i.to_send(); // (M1)
        tally.forecast_sent += i.forecast;
        if (!bidirectional_) {
            i.held = {};
            j.incident += sent_by_i;
            j.held += j.reflectance * sent_by_i;
            return;
        }
        const Rgb sent_by_j = j.to_send(); // (M2): both from before the exchange
        tally.forecast_sent += j.forecast;
        i.receive(sent_by_j);
        j.receive(sent_by_i);
    }

    void lose(WalkingPower& i, std::uint32_t where, BlockTally& tally) const
    {
        (where == Segment::behind ? tally.behind : tally.escaped) += i.to_send();
        tally.forecast_sent += i.forecast;
        i.held = {};
    }

    bool bidirectional_;
    std::vector<WalkingPower> patches_;
};

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
    Walk walk(scene, lines, pass, state);
    BlockTally total;
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
        BlockTally tally; // sums of one block stay small, which keeps the rounding errors of the balance small
        for (const Segment& segment : block.segments)
            walk.follow(segment, tally);
        total.forecast_sent += tally.forecast_sent;
        total.escaped += tally.escaped;
        total.behind += tally.behind;
        count_lines(block.items.size());
    };
    ordered_blocks((pass.lines_cast + lines_per_block - 1) / lines_per_block, threads, produce, exchange_in_order);
    walk.finish(total, state);
}

} // namespace multipath
