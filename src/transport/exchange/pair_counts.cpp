// Counts of all pairs of patches along global lines. A line through k surfaces has up to k (k - 1) / 2 facing pairs,
// neighbours or not. Threads trace blocks of lines and record their pairs; the records are added to the matrix by one
// thread at a time. Lines with many crossings are the exception: their pairs would take too much memory, so only their
// passages are kept, and the pairs are enumerated while they are added.

#include "transport/exchange/pair_counts.h"

#include "parallel/stage.h"
#include "transport/lines/depth_complexity.h"
#include "transport/lines/line_segments.h"

#include <algorithm>

namespace multipath {

namespace {

constexpr std::size_t many_crossings = 64; ///< a line with more crossings has too many pairs to record them

/// The pairs and losses of one block of lines.
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
    /// The passages of one line, as a range of `passages`.
    struct Passages
    {
        std::size_t first;
        std::size_t count;
    };

    LineBlock lines;
    std::vector<Passage> passages;
    std::vector<Pair> pairs;
    std::vector<Loss> losses;
    std::vector<Passages> long_lines; ///< lines with many crossings, whose pairs are not in `pairs`
};

/// Calls visit(index in a PairMatrix, joined) for every facing pair along one line, neighbours or not.
template <class Visit>
void for_each_pair(const Passage* passages, std::size_t count, const Visit& visit)
{
    for (std::size_t a = 0; a < count; ++a) {
        const std::uint32_t from = passages[a].leaves;
        if (!Segment::is_patch(from))
            continue;
        for (std::size_t b = a + 1; b < count; ++b)
            if (Segment::is_patch(passages[b].arrives_at))
                visit(PairMatrix<PairCount>::index(from, passages[b].arrives_at), b == a + 1);
    }
}

/// Records the patches along one line that send power to no patch, in either direction of the line.
void record_losses(const Passage* passages, std::size_t count, PairBlock& block)
{
    for (std::size_t a = 0; a < count; ++a) {
        const std::uint32_t from = passages[a].leaves;
        const bool arrives_alone = a == 0 || !Segment::is_patch(passages[a - 1].leaves);
        if (Segment::is_patch(passages[a].arrives_at) && arrives_alone)
            block.losses.push_back({passages[a].arrives_at, a > 0});
        if (Segment::is_patch(from) && (a + 1 == count || !Segment::is_patch(passages[a + 1].arrives_at)))
            block.losses.push_back({from, a + 1 < count});
    }
}

/// Records the facing pairs and the losses of one line, whose passages are first ... first + count - 1 of the block.
void record(std::size_t first, std::size_t count, PairBlock& block)
{
    const Passage* passages = block.passages.data() + first;
    record_losses(passages, count, block);
    if (count > many_crossings)
        block.long_lines.push_back({first, count});
    else
        for_each_pair(passages, count, [&](std::size_t index, bool joined) { block.pairs.push_back({index, joined}); });
}

/// Adds the records of a block to the counts.
void add(const PairBlock& block, PairCounts& counts)
{
    PairCount* pairs = counts.pairs.row(0);
    const auto add_pair = [pairs](std::size_t index, bool joined) {
        pairs[index].through += 1;
        pairs[index].joined += joined ? 1 : 0;
    };
    for (const PairBlock::Pair& pair : block.pairs)
        add_pair(pair.index, pair.joined);
    for (const PairBlock::Passages& line : block.long_lines)
        for_each_pair(block.passages.data() + line.first, line.count, add_pair);
    for (const PairBlock::Loss& loss : block.losses)
        (loss.behind ? counts.behind : counts.escaped)[loss.patch] += 1;
}

/// The lines, and the counts of their pairs and losses.
struct CountStage
{
    using Block = PairBlock;

    Blocks lines() const { return plan.lines; }
    void trace(std::uint64_t number, PairBlock& block) const
    {
        block.pairs.clear();
        block.losses.clear();
        block.long_lines.clear();
        const HitLists& lists = block.lines.trace(plan, number);
        find_passages(plan.scene, lists, block.passages);
        std::size_t first = 0;
        for (std::size_t line = 0; line < lists.size(); ++line) {
            record(first, lists[line].size(), block);
            first += lists[line].size();
        }
    }
    std::uint64_t take(std::uint64_t, const PairBlock& block)
    {
        add(block, counts);
        counts.lines += block.lines.lines();
        return block.lines.lines();
    }
    void visit(Archive& archive) { counts.visit(archive); }

    const LineBlocks plan;
    PairCounts counts;
};

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
    const double crossings = std::min(crossings_per_line(scene, lines), static_cast<double>(many_crossings));
    const std::uint64_t together = lines_per_block(0.5 * crossings * crossings + crossings);
    CountStage stage{{scene, lines, sequence, first_item, {lines_cast, together}}, PairCounts(scene.patch_count())};
    run_stage("pair counts", stage, run);
    return std::move(stage.counts);
}

} // namespace multipath
