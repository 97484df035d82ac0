#pragma once

#include "transport/exchange/exchange.h"
#include "transport/exchange/line_counts.h"

#include <vector>

namespace multipath {

/// Exchange areas counted by global lines (R1), closed so that no light is made or lost: symmetric, nowhere negative,
/// and with rows that add up to the areas of the patches. Two steps lead from the counts C_ij to them:
///
/// 1. G_ij = x_i x_j c C_ij, with c = 1 / expected_crossings(1 m^2) (G1) and one factor per patch, found by the
///    symmetric form of the iteration of Sinkhorn and Knopp (1967). The factors take out the noise of how many lines
///    happened to cross each patch. No row gets more than its area.
/// 2. What a row still lacks, s_i, is exchange that no line has shown. It is spread over all patches that lack some:
///    s_i s_j / sum of s. With tens of lines per patch this is a small part of the whole, see unseen_share().
class SparseExchange : public Exchange
{
public:
    /// Refers to the counts, which must be merged. `area` [m^2] per patch; `crossing_area` [m^2 per line] is c.
    /// `unseen_lines`: how many lines per patch to take as not seen, over those that were counted. With more than none,
    /// light can get from every patch to every other, however few lines there are, at the price of a bias.
    SparseExchange(const LineCounts& counts, const std::vector<double>& area, double crossing_area, double unseen_lines,
                   int threads);

    std::uint32_t size() const override { return counts_.size(); }
    std::vector<Rgb> apply(const std::vector<Rgb>& x, int threads) const override;
    double self_exchange(std::uint32_t patch) const override;
    double escaping(std::uint32_t patch) const override;
    double behind(std::uint32_t patch) const override;
    double row_area(std::uint32_t patch) const override { return area_[patch]; }

    /// [1] Share of all exchange that no line has shown: how far the result rests on step 2.
    double unseen_share() const;

private:
    /// Sums of all rows for the present factors, without what is not seen.
    std::vector<double> row_sums(bool limited, int threads) const;
    double factor(std::uint32_t i, std::uint32_t j) const;
    double lost(std::uint32_t patch, std::uint64_t lines) const;

    const LineCounts& counts_;
    std::vector<double> area_;
    double crossing_area_;
    std::vector<double> scale_;  ///< x
    std::vector<double> limit_;  ///< at most 1: keeps the rows from more than their areas
    std::vector<double> unseen_; ///< [m^2] s
    double unseen_sum_ = 0.0;    ///< [m^2]
};

} // namespace multipath
