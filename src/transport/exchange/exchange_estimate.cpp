#include "transport/exchange/exchange_estimate.h"

#include "parallel/blocks.h"

#include <algorithm>
#include <limits>

namespace multipath {

namespace {

/// Which block of its surface a cell belongs to; below ceil(cells_u / cells) * ceil(cells_v / cells).
std::uint32_t block_in_surface(const Tessellation& grid, std::uint32_t cell, std::uint32_t cells)
{
    const Surface unit = {grid.shape, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Vec3 place = grid.cell(unit, cell).centre();
    const auto along = [&](double x, std::uint32_t count) {
        return std::min(static_cast<std::uint32_t>(x * count), count - 1) / cells;
    };
    return along(place.x, grid.cells_u) * ((grid.cells_v - 1) / cells + 1) + along(place.y, grid.cells_v);
}

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

double block_count(const Scene& scene, std::uint32_t cells)
{
    double count = 0.0;
    for (std::uint32_t surface = 0; surface < scene.surfaces().size(); ++surface)
        count += blocks_in_surface(scene.tessellation(surface), cells);
    return (scene.two_sided() ? 2.0 : 1.0) * count;
}

PatchBlocks surface_blocks(const Scene& scene)
{
    return patch_blocks(scene, std::numeric_limits<std::uint32_t>::max());
}

// The exchange G of a pair with nothing in between is known exactly. Of the lines through both patches a share V is
// free of obstacles; G V is wanted. Counting the free lines alone, G V ~ a * joined (a: area per crossing), suffers
// from the chance by which lines meet the two patches at all. That chance shows in all lines through them, whose
// expectation G / a is known; so it can be taken out (a control variate):
//
//   G V ~ beta G + a (joined - beta * through)          (R2)
//
// is right on the average for any beta, and has no error at all where beta = V = 1 or beta = V = 0, the fate of most
// pairs. The best beta is V itself; neighbouring pairs tell it well enough. So beta is taken from blocks of patches,
// each share leaning on the one of the larger blocks around it where lines are few.

namespace {

constexpr std::uint32_t fine_cells = 2;
constexpr std::uint32_t middle_cells = 4;
constexpr double prior_lines = 1.0; ///< how many lines the share of the larger blocks is worth

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

/// Shares of free lines between blocks of one size.
struct BlockLevel
{
    explicit BlockLevel(PatchBlocks patch_blocks) : blocks(std::move(patch_blocks)), counts(blocks.count) {}

    PatchBlocks blocks;
    PairMatrix<BlockCount> counts;
};

/// For each block of the finer level the one that holds it.
std::vector<std::uint32_t> holders(const PatchBlocks& fine, const PatchBlocks& coarse)
{
    std::vector<std::uint32_t> holder(fine.count);
    for (std::size_t patch = 0; patch < fine.block_of.size(); ++patch)
        holder[fine.block_of[patch]] = coarse.block_of[patch];
    return holder;
}

/// Patches first ... end - 1 lie on the same side of one surface.
struct PatchRange
{
    std::uint32_t first;
    std::uint32_t end;
};

std::vector<PatchRange> sides(const PatchBlocks& surfaces)
{
    std::vector<PatchRange> ranges(surfaces.count);
    for (std::uint32_t patch = 0; patch < surfaces.block_of.size(); ++patch) {
        PatchRange& range = ranges[surfaces.block_of[patch]];
        if (range.end == 0)
            range.first = patch;
        range.end = patch + 1;
    }
    return ranges;
}

/// Calls visit(i, j) for all patches i and the patches j of surfaces before its own. Patches of one surface never see
/// each other. Different surfaces at the same time.
template <class Visit>
void for_pairs_of_surfaces(const std::vector<PatchRange>& ranges, int threads, const Visit& visit)
{
    parallel_blocks(ranges.size(), threads, [&](std::uint64_t number) {
        const PatchRange range = ranges[ranges.size() - 1 - number]; // long rows first
        for (std::uint32_t i = range.first; i < range.end; ++i)
            for (std::uint32_t j = 0; j < range.first; ++j)
                visit(i, j);
    });
}

/// Sums of the finer level's counts.
void add_counts(const BlockLevel& fine, BlockLevel& coarse)
{
    const std::vector<std::uint32_t> holder = holders(fine.blocks, coarse.blocks);
    for (std::uint32_t a = 0; a < fine.blocks.count; ++a)
        for (std::uint32_t b = 0; b <= a; ++b)
            coarse.counts.at(holder[a], holder[b]) += fine.counts.at(a, b);
}

/// The share of free lines between blocks; `prior(a, b)` is what to expect of it without any line.
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

/// The shares between the blocks of the finest level, each leaning on those of the coarser ones.
PairMatrix<double> lean_on_coarser(const BlockLevel& fine, const BlockLevel& middle, const BlockLevel& coarse)
{
    BlockCount all;
    for (std::uint32_t a = 0; a < coarse.blocks.count; ++a)
        for (std::uint32_t b = 0; b <= a; ++b)
            all += coarse.counts.at(a, b);
    const double overall = (all.joined + 1.0) / (all.through + 1.0);
    const auto leaning_on = [](const PatchBlocks& blocks, const PatchBlocks& around, const PairMatrix<double>& share) {
        return [holder = holders(blocks, around), &share](std::uint32_t a, std::uint32_t b) {
            return share.at(holder[a], holder[b]);
        };
    };
    const PairMatrix<double> by_surface = shares(coarse, [&](std::uint32_t, std::uint32_t) { return overall; });
    const PairMatrix<double> by_middle = shares(middle, leaning_on(middle.blocks, coarse.blocks, by_surface));
    return shares(fine, leaning_on(fine.blocks, middle.blocks, by_middle));
}

/// What the share of a block would be without the lines of one of its pairs.
double share_without(const PairCount& count, const BlockCount& block, double share)
{
    const double joined = share * (block.through + prior_lines) - static_cast<double>(count.joined);
    const double through = block.through + prior_lines - static_cast<double>(count.through);
    return std::clamp(joined / through, 0.0, 1.0); // rounding
}

/// How far the deviation of a patch's own counts is trusted: little where few lines cross it, since noise that exceeds
/// the exchange itself would make the equations unstable.
double trust(double lines_across)
{
    constexpr double few = 16.0;
    const double square = (lines_across / few) * (lines_across / few);
    return square * square / (1.0 + square * square);
}

} // namespace

double estimation_bytes(const Scene& scene)
{
    const double surfaces = static_cast<double>(scene.surfaces().size()) * (scene.two_sided() ? 2.0 : 1.0);
    double pairs = 0.0;
    for (const double blocks : {block_count(scene, fine_cells), block_count(scene, middle_cells), surfaces})
        pairs += 0.5 * blocks * (blocks + 1.0);
    return (sizeof(BlockCount) + sizeof(double)) * pairs;
}

ExchangeEstimate estimate_exchange(const Scene& scene, const PairMatrix<float>& unoccluded, const PairCounts& counts,
                                   double crossing_area, int threads)
{
    const std::uint32_t n = scene.patch_count();
    BlockLevel fine(patch_blocks(scene, fine_cells));
    BlockLevel middle(patch_blocks(scene, middle_cells));
    BlockLevel coarse(surface_blocks(scene));
    const std::vector<PatchRange> ranges = sides(coarse.blocks);
    for_pairs_of_surfaces(ranges, threads, [&](std::uint32_t i, std::uint32_t j) {
        const PairCount& count = counts.pairs.at(i, j);
        if (count.through > 0)
            fine.counts.at(fine.blocks.block_of[i], fine.blocks.block_of[j]) +=
                {static_cast<double>(count.joined), static_cast<double>(count.through)};
    });
    add_counts(fine, middle);
    add_counts(middle, coarse);
    const PairMatrix<double> share = lean_on_coarser(fine, middle, coarse);

    std::vector<double> trusted(n);
    for (std::uint32_t i = 0; i < n; ++i)
        trusted[i] = trust(scene.area(i) / crossing_area);

    ExchangeEstimate estimate{PairMatrix<float>(n), PairMatrix<float>(n)};
    for_pairs_of_surfaces(ranges, threads, [&](std::uint32_t i, std::uint32_t j) {
        const double free_exchange = static_cast<double>(unoccluded.at(i, j));
        if (!(free_exchange > 0.0))
            return;
        const std::uint32_t a = fine.blocks.block_of[i];
        const std::uint32_t b = fine.blocks.block_of[j];
        const PairCount& count = counts.pairs.at(i, j);
        const BlockCount& around = fine.counts.at(a, b);
        const double beta = share_without(count, around, share.at(a, b));
        const double deviation = static_cast<double>(count.joined) - beta * static_cast<double>(count.through);
        estimate.exchange.at(i, j) =
            static_cast<float>(beta * free_exchange + trusted[i] * trusted[j] * crossing_area * deviation);

        // Unanimous lines do not prove that all would agree: as if one in twenty more had dissented, both ways.
        const double p = (around.joined + beta + 0.05) / (around.through + 1.1);
        estimate.variance.at(i, j) = static_cast<float>(crossing_area * free_exchange * p * (1.0 - p));
    });
    return estimate;
}

} // namespace multipath
