#pragma once

#include "scene/scene.h"
#include "transport/exchange/pair_counts.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// A partition of the patches into blocks of neighbours on one side of one surface. Blocks are numbered like patches:
/// surface by surface, all blocks of fronts before those of backs.
struct PatchBlocks
{
    std::uint32_t count = 0;             ///< number of blocks
    std::vector<std::uint32_t> block_of; ///< per patch
};

/// Blocks of up to cells x cells squares of the grid of a surface (Tessellation). A square is one patch of a
/// parallelogram, up to two patches of a triangle. The blocks for 2 * cells are unions of the blocks for `cells`.
/// Blocks of the grid that lie outside a triangle are counted, but empty.
PatchBlocks patch_blocks(const Scene& scene, std::uint32_t cells);

/// One block for every side of a surface that has patches.
PatchBlocks surface_blocks(const Scene& scene);

/// Estimated exchange areas (exchange.h) of all pairs of patches.
struct ExchangeEstimate
{
    PairMatrix<float> exchange; ///< [m^2]
    PairMatrix<float> variance; ///< [m^4] rough variance of each estimate; 0 for pairs without unoccluded exchange,
                                ///< whose estimates are 0

    void visit(Archive& archive) ///< for a checkpoint
    {
        exchange.visit<float>(archive, "exchange");
        variance.visit<float>(archive, "variance");
    }
};

/// [bytes] Working memory that estimate_exchange needs besides its arguments and its result.
double estimation_bytes(const Scene& scene);

/// Estimates the exchange area of each pair of patches ((R2) in docs/equations.md): about the `unoccluded` exchange
/// [m^2] times the fraction of the lines through both patches that meet no obstacle in between. The unoccluded exchange
/// serves as a control variate of the lines that joined the pair. `crossing_area` [m^2] is the area that the counted
/// lines together cross once in expectation: 1 / (their expected crossings of 1 m^2).
ExchangeEstimate estimate_exchange(const Scene& scene, const PairMatrix<float>& unoccluded, const PairCounts& counts,
                                   double crossing_area, int threads);

} // namespace multipath
