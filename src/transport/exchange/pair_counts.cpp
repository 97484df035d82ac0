// Counts of all pairs of patches along global lines. A line through k surfaces has up to k (k - 1) / 2 facing pairs,
// neighbours or not. Threads trace blocks of lines and find their passages; one thread at a time counts the pairs.

#include "transport/exchange/pair_counts.h"

#include "parallel/stage.h"
#include "transport/lines/depth_complexity.h"
#include "transport/lines/line_segments.h"

#include <utility>

namespace multipath {

namespace {

/// The passages along the lines of one block.
struct PassageBlock
{
    LineBlock lines;
    std::vector<Passage> passages;
    std::vector<std::size_t> ends; ///< per line: one past its last passage
};

/// Counts the facing pairs along one line, neighbours or not, and the patches that send power to no patch, in either
/// direction of the line.
void add_line(const Passage* passages, std::size_t count, PairCounts& counts)
{
    const auto patch_leaves = [&](std::size_t a) { return Segment::is_patch(passages[a].leaves); };
    const auto patch_arrives = [&](std::size_t a) { return Segment::is_patch(passages[a].arrives_at); };
    for (std::size_t a = 0; a < count; ++a) {
        if (patch_arrives(a) && (a == 0 || !patch_leaves(a - 1)))
            ++(a > 0 ? counts.behind : counts.escaped)[passages[a].arrives_at];
        if (!patch_leaves(a))
            continue;
        const std::uint32_t from = passages[a].leaves;
        if (a + 1 == count || !patch_arrives(a + 1))
            ++(a + 1 < count ? counts.behind : counts.escaped)[from];
        for (std::size_t b = a + 1; b < count; ++b)
            if (patch_arrives(b)) {
                PairCount& pair = counts.pairs.at(from, passages[b].arrives_at);
                pair.through += 1;
                pair.joined += b == a + 1 ? 1 : 0;
            }
    }
}

/// The lines, and the counts of their pairs and losses.
struct CountStage
{
    using Block = PassageBlock;

    Blocks lines() const { return plan.lines; }
    void trace(std::uint64_t number, PassageBlock& block) const
    {
        const HitLists& lists = block.lines.trace(plan, number);
        block.passages.clear();
        block.ends.clear();
        for (std::size_t line = 0; line < lists.size(); ++line) {
            for (const Hit& hit : lists[line])
                block.passages.push_back(passage_at(plan.scene, hit));
            block.ends.push_back(block.passages.size());
        }
    }
    std::uint64_t take(std::uint64_t, const PassageBlock& block)
    {
        std::size_t first = 0;
        for (const std::size_t end : block.ends) {
            add_line(block.passages.data() + first, end - first, counts);
            first = end;
        }
        counts.lines += block.ends.size();
        return block.ends.size();
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
    const Blocks blocks = {lines_cast, lines_per_block(crossings_per_line(scene, lines))};
    CountStage stage{{scene, lines, sequence, first_item, blocks}, PairCounts(scene.patch_count())};
    run_stage("pair counts", stage, run);
    return std::move(stage.counts);
}

} // namespace multipath
