#pragma once

#include "transport/exchange/exchange.h"
#include "transport/exchange/line_counts.h"

#include <cstdint>
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
///    s_i s_j / sum of s. With tens of rays per patch this is a small part of the whole, see unseen_share(). What only
///    rounding makes it lack, a patch exchanges with itself, so that no light gets into closed spaces.
class SparseExchange : public Exchange
{
public:
    /// Refers to the counts, which must be merged. `area` [m^2] and `density` [rays/m^2] per patch, of the rays that
    /// left it. `unseen_rays`: how many rays per patch to take as not seen, over those that were counted. With more
    /// than none, light can get from every patch to every other, however few rays there are, at the price of a bias.
    SparseExchange(const LineCounts& counts, const std::vector<double>& area, const std::vector<double>& density,
                   double unseen_rays, int threads);

    std::uint32_t size() const override { return counts_.size(); }
    void multiply(const std::vector<Rgb>& x, int threads, std::vector<Rgb>& y) const override;
    double self_exchange(std::uint32_t patch) const override;
    double escaping(std::uint32_t patch) const override { return lost(patch, counts_.escaped(patch)); }
    double behind(std::uint32_t patch) const override { return lost(patch, counts_.behind(patch)); }
    double row_area(std::uint32_t patch) const override { return area_[patch]; }

    /// [1] Share of all exchange that no ray has shown: how far the result rests on step 2.
    double unseen_share() const;

private:
    /// Single precision serves as well and is half to read: the exchange is symmetric in any case, and adds up to the
    /// areas by step 2.
    struct Factors
    {
        float density; ///< [rays per unit_] d
        float scale;   ///< x
    };

    double lost(std::uint32_t patch, std::uint64_t rays) const;
    double row_sum(std::uint32_t i) const;
    void balance(const std::vector<double>& wanted, int threads);

    const LineCounts& counts_;
    std::vector<double> area_;
    double unit_ = 0.0; ///< [m^2] of all patches: in single precision, numbers must not be too large or small
    std::vector<Factors> factors_;
    std::vector<double> own_;    ///< [m^2] what rounding makes the row lack
    std::vector<double> unseen_; ///< [m^2] s
    double unseen_sum_ = 0.0;    ///< [m^2]
};

} // namespace multipath
