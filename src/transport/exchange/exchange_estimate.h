#pragma once

#include "scene/scene.h"
#include "transport/exchange/pair_counts.h"
#include "transport/exchange/pair_matrix.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Neighbouring patches of one surface taken together. Blocks are numbered in the order of their surfaces, like
/// patches.
struct PatchBlocks
{
    std::uint32_t count = 0;
    std::vector<std::uint32_t> block_of; ///< per patch
};

/// Blocks of up to cells x cells patches. Blocks of 2 k cells are made of whole blocks of k cells.
PatchBlocks patch_blocks(const Scene& scene, std::uint32_t cells);

/// How many there are, without finding them.
double block_count(const Scene& scene, std::uint32_t cells);

/// One block for every surface, and for its back where it has patches.
PatchBlocks surface_blocks(const Scene& scene);

/// What is known of the exchange of all pairs of patches.
struct ExchangeEstimate
{
    PairMatrix<float> exchange; ///< [m^2]
    PairMatrix<float> variance; ///< [m^4] of the estimate, roughly; zero where the pair cannot see each other
};

/// Bytes that estimate_exchange takes, besides the estimate.
double estimation_bytes(const Scene& scene);

/// The exchange of each pair: what it would be with nothing in between, times the share of the lines through both
/// patches that is free. `crossing_area` [m^2] is the area per line that crosses it (1 / expected crossings of 1 m^2).
ExchangeEstimate estimate_exchange(const Scene& scene, const PairMatrix<float>& unoccluded, const PairCounts& counts,
                                   double crossing_area, int threads);

} // namespace multipath
