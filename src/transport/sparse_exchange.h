#pragma once

#include "transport/exchange.h"
#include "transport/line_counts.h"

#include <vector>

namespace multipath {

/// The exchange as global lines counted it: G_ij = crossing_area * C_ij (R1), exactly symmetric, with rows that add up
/// to an estimate of each patch's area.
class SparseExchange : public Exchange
{
public:
    /// Refers to the counts, which must be merged. crossing_area [m^2 per line] is 1 / expected_crossings(1 m^2) of the
    /// lines cast for them (G1).
    SparseExchange(const LineCounts& counts, double crossing_area, int threads);

    std::uint32_t size() const override { return counts_.size(); }
    std::vector<Rgb> apply(const std::vector<Rgb>& x, int threads) const override;
    double self_exchange(std::uint32_t) const override { return 0.0; }
    double escaping(std::uint32_t patch) const override;
    double behind(std::uint32_t patch) const override;
    double row_area(std::uint32_t patch) const override { return row_area_[patch]; }

private:
    const LineCounts& counts_;
    double crossing_area_;
    std::vector<double> row_area_;
};

} // namespace multipath
