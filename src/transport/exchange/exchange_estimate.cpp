#include "transport/exchange/exchange_estimate.h"

#include "base/disjoint_sets.h"
#include "parallel/blocks.h"

#include <algorithm>
#include <limits>

namespace multipath {

namespace {

constexpr std::uint32_t whole_surface = std::numeric_limits<std::uint32_t>::max(); ///< cells of a block

/// Index of the block of its surface to which a cell belongs, below blocks_in_surface(grid, cells).
std::uint32_t block_in_surface(const Tessellation& grid, std::uint32_t cell, std::uint32_t cells)
{
    const Surface unit = {grid.shape, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Vec3 centre = grid.cell(unit, cell).centre();
    const auto along = [&](double x, std::uint32_t count) {
        return std::min(static_cast<std::uint32_t>(x * count), count - 1) / cells;
    };
    return along(centre.x, grid.cells_u) * ((grid.cells_v - 1) / cells + 1) + along(centre.y, grid.cells_v);
}

/// ceil(cells_u / cells) * ceil(cells_v / cells).
std::uint32_t blocks_in_surface(const Tessellation& grid, std::uint32_t cells)
{
    return ((grid.cells_u - 1) / cells + 1) * ((grid.cells_v - 1) / cells + 1);
}

} // namespace

PatchBlocks patch_blocks(const Scene& scene, std::uint32_t cells)
{
    PatchBlocks blocks;
    blocks.block_of.reserve(scene.patch_count());
    for (int side = 0; side < (scene.two_sided() ? 2 : 1); ++side)
        for (std::uint32_t surface = 0; surface < scene.surfaces().size(); ++surface) {
            const Tessellation& grid = scene.tessellation(surface);
            for (std::uint32_t cell = 0; cell < grid.cell_count(); ++cell)
                blocks.block_of.push_back(blocks.count + block_in_surface(grid, cell, cells));
            blocks.count += blocks_in_surface(grid, cells);
        }
    return blocks;
}

PatchBlocks surface_blocks(const Scene& scene)
{
    return patch_blocks(scene, whole_surface);
}

// The unoccluded exchange G0 of a pair is known exactly. A share V of the lines through both patches is free of
// obstacles, and G = G0 V is wanted. The plain estimate from the free lines, G ~ a * joined (a: area per crossing), has
// the noise of how many lines happen to pass through the two patches at all. The number of all lines through them has
// the same noise, and its expectation G0 / a is known. So it serves as a control variate:
//
//   G ~ beta G0 + a (joined - beta * through)          (R2)
//
// is unbiased for any beta that is independent of these lines, and exact if beta = V = 1 or beta = V = 0, the case of
// most pairs. The best beta is V itself. It is estimated from the lines between blocks of neighbouring patches, without
// those of the pair itself (leave-one-out). The estimates of small blocks shrink towards those of the larger blocks
// around them where lines are few (shrinkage, empirical Bayes).

namespace {

constexpr std::uint32_t fine_cells = 2;   ///< along an edge of a block
constexpr std::uint32_t middle_cells = 4; ///< likewise
constexpr double prior_lines = 1.0;       ///< weight of the prior from the larger blocks, as a number of lines

/// The sum of the PairCounts between two blocks.
struct BlockCount
{
    double joined = 0.0;
    double through = 0.0;

    BlockCount& operator+=(const BlockCount& other)
    {
        joined += other.joined;
        through += other.through;
        return *this;
    }
};

/// Counts of lines between blocks of one size.
struct BlockLevel
{
    explicit BlockLevel(PatchBlocks patch_blocks) : blocks(std::move(patch_blocks)), counts(blocks.count) {}
    BlockLevel(PatchBlocks patch_blocks, const BlockLevel& finer); ///< with the sums of the counts of a finer level

    PatchBlocks blocks;
    PairMatrix<BlockCount> counts;
};

/// For each block of the finer level, the block of the coarser level that contains it.
std::vector<std::uint32_t> parent_blocks(const PatchBlocks& fine, const PatchBlocks& coarse)
{
    std::vector<std::uint32_t> parent(fine.count);
    for (std::size_t patch = 0; patch < fine.block_of.size(); ++patch)
        parent[fine.block_of[patch]] = coarse.block_of[patch];
    return parent;
}

/// Calls visit(i, j) for every patch i and all patches j of the sides before its own; patches of one side never see
/// each other. Sides run in parallel.
template <class Visit>
void for_pairs_of_surfaces(const Scene& scene, int threads, const Visit& visit)
{
    const std::uint64_t surfaces = scene.surfaces().size();
    const std::uint64_t sides = scene.two_sided() ? 2 * surfaces : surfaces;
    parallel_blocks(sides, threads, [&](std::uint64_t number) {
        const std::uint64_t side = sides - 1 - number; // long rows first
        const auto surface = static_cast<std::uint32_t>(side % surfaces);
        const std::uint32_t first = scene.first_patch(surface, side < surfaces);
        for (std::uint32_t i = first; i < first + scene.tessellation(surface).cell_count(); ++i)
            for (std::uint32_t j = 0; j < first; ++j)
                visit(i, j);
    });
}

BlockLevel::BlockLevel(PatchBlocks patch_blocks, const BlockLevel& finer) : BlockLevel(std::move(patch_blocks))
{
    const std::vector<std::uint32_t> parent = parent_blocks(finer.blocks, blocks);
    for (std::uint32_t a = 0; a < finer.blocks.count; ++a)
        for (std::uint32_t b = 0; b <= a; ++b)
            counts.at(parent[a], parent[b]) += finer.counts.at(a, b);
}

/// One block for all sides of surfaces that lines have joined with each other, directly or through others: what lies in
/// one space. The lines between two spaces, none of which was free, tell most about pairs that few lines have passed.
PatchBlocks joined_spaces(const BlockLevel& sides)
{
    DisjointSets spaces(sides.blocks.count);
    for (std::uint32_t a = 0; a < sides.blocks.count; ++a)
        for (std::uint32_t b = 0; b < a; ++b)
            if (sides.counts.at(a, b).joined > 0.0)
                spaces.unite(a, b);
    std::vector<std::uint32_t> number(sides.blocks.count);
    PatchBlocks result;
    for (std::uint32_t a = 0; a < sides.blocks.count; ++a)
        number[a] = spaces.root(a) == a ? result.count++ : number[spaces.root(a)];
    for (const std::uint32_t side : sides.blocks.block_of)
        result.block_of.push_back(number[side]);
    return result;
}

/// Estimated share of free lines between blocks: the posterior mean, with prior(a, b) weighted like prior_lines lines.
template <class Prior>
PairMatrix<double> shares(const BlockLevel& level, const Prior& prior)
{
    PairMatrix<double> share(level.blocks.count);
    for (std::uint32_t a = 0; a < level.blocks.count; ++a)
        for (std::uint32_t b = 0; b <= a; ++b) {
            const BlockCount& count = level.counts.at(a, b);
            share.at(a, b) = (count.joined + prior_lines * prior(a, b)) / (count.through + prior_lines);
        }
    return share;
}

/// The shares of free lines between the blocks of the finest level, each shrunk towards the share of the coarser
/// blocks.
PairMatrix<double> shrunk_shares(const BlockLevel& fine, const BlockLevel& middle, const BlockLevel& coarse)
{
    BlockCount all;
    for (std::uint32_t a = 0; a < coarse.blocks.count; ++a)
        for (std::uint32_t b = 0; b <= a; ++b)
            all += coarse.counts.at(a, b);
    const double overall = (all.joined + 1.0) / (all.through + 1.0);
    const auto prior_from = [](const PatchBlocks& blocks, const PatchBlocks& around, const PairMatrix<double>& share) {
        return [parent = parent_blocks(blocks, around), &share](std::uint32_t a, std::uint32_t b) {
            return share.at(parent[a], parent[b]);
        };
    };
    const BlockLevel spaces(joined_spaces(coarse), coarse);
    const PairMatrix<double> by_space = shares(spaces, [&](std::uint32_t, std::uint32_t) { return overall; });
    const std::vector<std::uint32_t> space = parent_blocks(coarse.blocks, spaces.blocks);
    const PairMatrix<double> by_surface = shares(coarse, [&](std::uint32_t a, std::uint32_t b) {
        return space[a] == space[b] ? overall : by_space.at(space[a], space[b]);
    });
    const PairMatrix<double> by_middle = shares(middle, prior_from(middle.blocks, coarse.blocks, by_surface));
    return shares(fine, prior_from(fine.blocks, middle.blocks, by_middle));
}

/// Leave-one-out estimate: the share of free lines between two blocks without the lines of one of their pairs.
double leave_one_out_share(const PairCount& count, const BlockCount& block, double share)
{
    const double joined = share * (block.through + prior_lines) - static_cast<double>(count.joined);
    const double through = block.through + prior_lines - static_cast<double>(count.through);
    return std::clamp(joined / through, 0.0, 1.0); // rounding
}

/// Weight [1] of the counts of a patch itself: small if few lines cross it, since noise larger than the exchange would
/// make the linear system unstable.
double trust(double lines_across)
{
    constexpr double few = 16.0;
    const double square = (lines_across / few) * (lines_across / few);
    return square * square / (1.0 + square * square);
}

} // namespace

double estimation_bytes(const Scene& scene)
{
    double pairs = 0.0;
    for (const std::uint32_t cells : {fine_cells, middle_cells, whole_surface, whole_surface}) {
        double blocks = 0.0; // that patch_blocks(scene, cells) makes
        for (std::uint32_t surface = 0; surface < scene.surfaces().size(); ++surface)
            blocks += (scene.two_sided() ? 2.0 : 1.0) * blocks_in_surface(scene.tessellation(surface), cells);
        pairs += 0.5 * blocks * (blocks + 1.0);
    }
    return (sizeof(BlockCount) + sizeof(double)) * pairs;
}

ExchangeEstimate estimate_exchange(const Scene& scene, const PairMatrix<float>& unoccluded, const PairCounts& counts,
                                   double crossing_area, int threads)
{
    const std::uint32_t n = scene.patch_count();
    BlockLevel fine(patch_blocks(scene, fine_cells));
    for_pairs_of_surfaces(scene, threads, [&](std::uint32_t i, std::uint32_t j) {
        const PairCount& count = counts.pairs.at(i, j);
        if (count.through > 0)
            fine.counts.at(fine.blocks.block_of[i], fine.blocks.block_of[j]) +=
                {static_cast<double>(count.joined), static_cast<double>(count.through)};
    });
    const BlockLevel middle(patch_blocks(scene, middle_cells), fine);
    const BlockLevel coarse(surface_blocks(scene), middle);
    const PairMatrix<double> share = shrunk_shares(fine, middle, coarse);

    const std::vector<double> trusted =
        parallel_list(n, threads, [&](std::uint32_t i) { return trust(scene.area(i) / crossing_area); });

    ExchangeEstimate estimate{PairMatrix<float>(n), PairMatrix<float>(n)};
    for_pairs_of_surfaces(scene, threads, [&](std::uint32_t i, std::uint32_t j) {
        const double free_exchange = static_cast<double>(unoccluded.at(i, j));
        if (!(free_exchange > 0.0))
            return;
        const std::uint32_t a = fine.blocks.block_of[i];
        const std::uint32_t b = fine.blocks.block_of[j];
        const PairCount& count = counts.pairs.at(i, j);
        const BlockCount& around = fine.counts.at(a, b);
        const double beta = leave_one_out_share(count, around, share.at(a, b));
        const double deviation = static_cast<double>(count.joined) - beta * static_cast<double>(count.through);
        estimate.exchange.at(i, j) =
            static_cast<float>(beta * free_exchange + trusted[i] * trusted[j] * crossing_area * deviation);

        // Pseudo-counts of 0.05 for each outcome keep p (1 - p) > 0 where all lines agree.
        const double p = (around.joined + beta + 0.05) / (around.through + 1.1);
        estimate.variance.at(i, j) = static_cast<float>(crossing_area * free_exchange * p * (1.0 - p));
    });
    return estimate;
}

} // namespace multipath
