#pragma once

#include "scene/scene.h"
#include "transport/exchange/pair_counts.h"
#include "transport/exchange/pair_matrix.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// A partition of the patches into blocks of neighbours on one side of one surface. Blocks are numbered surface by
/// surface, like patches.
struct PatchBlocks
{
    std::uint32_t count = 0;             ///< number of blocks
    std::vector<std::uint32_t> block_of; ///< per patch
};

/// Blocks of up to cells x cells patches. A block of 2 k cells is a union of blocks of k cells.
PatchBlocks patch_blocks(const Scene& scene, std::uint32_t cells);

/// The number of blocks that patch_blocks(scene, cells) makes.
double block_count(const Scene& scene, std::uint32_t cells);

/// One block for every side of a surface that has patches.
PatchBlocks surface_blocks(const Scene& scene);

/// Estimated exchange areas of all pairs of patches.
struct ExchangeEstimate
{
    PairMatrix<float> exchange; ///< [m^2]
    PairMatrix<float> variance; ///< [m^4] rough variance of each estimate; 0 for pairs without unoccluded exchange
};

/// Bytes of working memory that estimate_exchange needs besides its result.
double estimation_bytes(const Scene& scene);

/// Estimates the exchange area of each pair by a control variate (R2): its unoccluded exchange [m^2] times the share of
/// lines through both patches that meet no obstacle in between. `crossing_area` [m^2] is the area that one line crosses
/// once in expectation, 1 / (expected crossings of 1 m^2).
ExchangeEstimate estimate_exchange(const Scene& scene, const PairMatrix<float>& unoccluded, const PairCounts& counts,
                                   double crossing_area, int threads);

} // namespace multipath
