#pragma once

#include "scene/scene.h"
#include "transport/pair_counts.h"
#include "transport/pair_matrix.h"

namespace multipath {

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
