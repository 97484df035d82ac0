#pragma once

#include "transport/exchange/exchange.h"
#include "transport/exchange/line_counts.h"

#include <vector>

namespace multipath {

/// Exchange areas counted by rays (R4), closed so that no light is made or lost: symmetric, nowhere negative, and with
/// rows that add up to the areas of the patches. With d_i rays per m^2 of patch i, and C_ij of all rays between i and
/// j, from whichever end, the estimate is C_ij / (d_i + d_j): of all ways to weigh the two kinds of rays, this balance
/// heuristic of Veach and Guibas (1995) is never much worse than the best. Two steps lead from it to the exchange:
///
/// 1. G_ij = x_i x_j C_ij / (d_i + d_j), with one factor per patch, found by the symmetric form of the iteration of
///    Sinkhorn and Knopp (1967). The factors take out the noise of how many rays of others happened to meet each patch.
///    No row gets more than its area.
/// 2. What a row still lacks, s_i, is exchange that no ray has shown. It is spread over all patches that lack some:
///    s_i s_j / sum of s. With tens of rays per patch this is a small part of the whole, see unseen_share().
class SparseExchange : public Exchange
{
public:
    /// Refers to the counts, which must be merged. `area` [m^2] and `density` [rays/m^2] per patch, of the rays that
    /// left it. `unseen_rays`: how many rays per patch to take as not seen, over those that were counted. With more
    /// than none, light can get from every patch to every other, however few rays there are, at the price of a bias.
    /// `small_leak` [1]: by how much of all area the rows may differ from it after step 1.
    SparseExchange(const LineCounts& counts, const std::vector<double>& area, std::vector<double> density,
                   double unseen_rays, int threads, double small_leak = 1e-7);

    std::uint32_t size() const override { return counts_.size(); }
    std::vector<Rgb> apply(const std::vector<Rgb>& x, int threads) const override;
    double self_exchange(std::uint32_t patch) const override;
    double escaping(std::uint32_t patch) const override;
    double behind(std::uint32_t patch) const override;
    double row_area(std::uint32_t patch) const override { return area_[patch]; }

    /// [1] Share of all exchange that no ray has shown: how far the result rests on step 2.
    double unseen_share() const;

private:
    /// Sums of all rows for the present factors, without what is not seen.
    std::vector<double> row_sums(bool limited, int threads) const;
    double factor(std::uint32_t i, std::uint32_t j) const;
    double counted(std::uint32_t i, const CountEntry& entry) const; ///< [m^2] C_ij / (d_i + d_j)
    double lost(std::uint32_t patch, std::uint64_t rays) const;

    const LineCounts& counts_;
    std::vector<double> area_;
    std::vector<double> density_; ///< [rays/m^2] d
    std::vector<double> scale_;   ///< x
    std::vector<double> limit_;   ///< at most 1: keeps the rows from more than their areas
    std::vector<double> unseen_;  ///< [m^2] s
    double unseen_sum_ = 0.0;     ///< [m^2]
};

} // namespace multipath
