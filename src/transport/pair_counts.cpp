#include "transport/pair_counts.h"

#include "parallel/ordered_blocks.h"
#include "parallel/shared_blocks.h"
#include "transport/intersection_list.h"
#include "transport/line_block.h"

namespace multipath {

namespace {

/// What the lines of one block met.
struct PairBlock
{
    struct Pair
    {
        std::size_t index; ///< of a PairMatrix
        bool joined;
    };
    struct Loss
    {
        std::uint32_t patch;
        bool behind;
    };

    LineBlock lines;
    std::vector<Passage> passages;
    std::vector<Pair> pairs;
    std::vector<Loss> losses;
};

/// Notes every facing pair along one line, neighbours or not, and where power would be lost.
void note(const Passage* passages, std::size_t count, PairBlock& block)
{
    for (std::size_t a = 0; a < count; ++a) {
        const std::uint32_t from = passages[a].leaves;
        const bool arrives_alone = a == 0 || !Segment::is_patch(passages[a - 1].leaves);
        if (Segment::is_patch(passages[a].arrives_at) && arrives_alone)
            block.losses.push_back({passages[a].arrives_at, a > 0});
        if (!Segment::is_patch(from))
            continue;
        if (a + 1 == count || !Segment::is_patch(passages[a + 1].arrives_at))
            block.losses.push_back({from, a + 1 < count});
        for (std::size_t b = a + 1; b < count; ++b)
            if (Segment::is_patch(passages[b].arrives_at))
                block.pairs.push_back({PairMatrix<PairCount>::index(from, passages[b].arrives_at), b == a + 1});
    }
}

void add(const PairBlock& block, PairCounts& counts)
{
    PairCount* pairs = counts.pairs.row(0);
    for (const PairBlock::Pair& pair : block.pairs) {
        pairs[pair.index].through += 1;
        pairs[pair.index].joined += pair.joined ? 1 : 0;
    }
    for (const PairBlock::Loss& loss : block.losses)
        (loss.behind ? counts.behind : counts.escaped)[loss.patch] += 1;
}

} // namespace

PairCounts& PairCounts::operator+=(const PairCounts& others)
{
    lines += others.lines;
    for (std::uint32_t i = 0; i < pairs.size(); ++i) {
        for (std::uint32_t j = 0; j <= i; ++j) {
            pairs.at(i, j).joined += others.pairs.at(i, j).joined;
            pairs.at(i, j).through += others.pairs.at(i, j).through;
        }
        escaped[i] += others.escaped[i];
        behind[i] += others.behind[i];
    }
    return *this;
}

void PairCounts::visit(Archive& archive)
{
    archive.value<std::uint64_t>("lines", lines);
    pairs.visit<std::uint32_t>(archive, "pairs");
    archive.list<std::uint64_t>("escaped", escaped);
    archive.list<std::uint64_t>("behind", behind);
}

PairCounts count_pairs(const Scene& scene, const GlobalLines& lines, const Sequence& sequence, std::uint64_t first_item,
                       std::uint64_t lines_cast, const RunControl& run)
{
    PairCounts counts(scene.patch_count());
    SharedRange range = SharedRange::of(LineBlock::blocks_for(lines_cast), run.share);
    const Checkpoint::Part part(run.checkpoint, "pair counts", [&](Archive& archive) {
        range.visit(archive);
        counts.visit(archive);
    });
    std::vector<PairBlock> blocks(static_cast<std::size_t>(slot_count(run.threads)));
    const auto trace_block = [&](std::uint64_t number, int slot) {
        PairBlock& block = blocks[static_cast<std::size_t>(slot)];
        block.pairs.clear();
        block.losses.clear();
        const HitLists& lists = block.lines.trace(scene, lines, sequence, first_item, lines_cast, number);
        find_passages(scene, lists, block.passages);
        const Passage* next = block.passages.data();
        for (std::size_t line = 0; line < lists.size(); ++line) {
            note(next, lists[line].size(), block);
            next += lists[line].size();
        }
    };
    const auto add_block = [&](std::uint64_t, int slot) {
        const PairBlock& block = blocks[static_cast<std::size_t>(slot)];
        add(block, counts);
        counts.lines += block.lines.lines();
        run.count_lines(block.lines.lines());
    };
    shared_blocks(range, run, trace_block, add_block);
    return counts;
}

} // namespace multipath
