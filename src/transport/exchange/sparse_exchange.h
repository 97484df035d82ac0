#pragma once

#include "transport/exchange/exchange.h"
#include "transport/exchange/line_counts.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Exchange areas (exchange.h) estimated from counts of rays ((R4) in docs/equations.md), closed so that light is
/// conserved: symmetric, nowhere negative but for rounding, and with row sums equal to the areas of the patches. A row
/// sum here includes the losses (escaping and behind). With d_i rays per m^2 of patch i, and C_ij rays between i and j,
/// started at either end, the estimate of A_i F_ij is C_ij / (d_i + d_j): the balance heuristic of Veach and Guibas
/// (1995), which is never much worse than the best combination of the two kinds of rays. Two steps close the estimate:
///
/// Step 1: G_ij = x_i x_j C_ij / (d_i + d_j), with one factor x per patch, by symmetric matrix balancing after Sinkhorn
/// and Knopp (1967). The factors remove the noise of how many rays of other patches happened to meet each patch. After
/// the step no row sum exceeds the area of the patch.
///
/// Step 2: The deficit delta_i, the area of patch i minus its row sum, is exchange that no ray has sampled. It is
/// spread over all patches with a deficit: G_ij grows by delta_i delta_j / sum of delta. With tens of rays per patch
/// this is a small part of the whole (unseen_share()). A deficit from rounding alone becomes self-exchange instead, so
/// that no light gets into closed spaces.
class SparseExchange : public Exchange
{
public:
    /// Keeps a reference to the counts, which must be merged. `area` [m^2] is per patch, and so is `density`
    /// [rays/m^2], the number of rays that left the patch over its area. `unseen_rays` is a pseudo-count: so many rays
    /// per patch, besides the counted ones, are taken to have reached unknown patches. A positive number lets light get
    /// from every patch to every other, however few rays there are, at the price of a bias.
    SparseExchange(const LineCounts& counts, const std::vector<double>& area, const std::vector<double>& density,
                   double unseen_rays, int threads);

    std::uint32_t size() const override { return counts_.size(); }
    void multiply(const std::vector<Rgb>& x, int threads, std::vector<Rgb>& y) const override;
    double self_exchange(std::uint32_t patch) const override;
    double escaping(std::uint32_t patch) const override { return lost(patch, counts_.escaped(patch)); }
    double behind(std::uint32_t patch) const override { return lost(patch, counts_.behind(patch)); }
    double row_area(std::uint32_t patch) const override { return area_[patch]; }

    /// [1] Fraction of the total area that step 2 adds: exchange that no ray has sampled.
    double unseen_share() const;

private:
    /// Single precision suffices and halves the memory to be read: the exchange stays exactly symmetric, and step 2
    /// makes its rows add up to the areas.
    struct Factors
    {
        float density; ///< d [rays per unit_]
        float scale;   ///< x [1]
    };

    double lost(std::uint32_t patch, std::uint64_t rays) const;
    double row_sum(std::uint32_t i) const;
    void balance(const std::vector<double>& wanted, int threads);

    const LineCounts& counts_;
    std::vector<double> area_;
    double unit_ = 0.0; ///< [m^2] total area, the unit of areas that keeps numbers within the range of floats
    std::vector<Factors> factors_;
    std::vector<double> own_;    ///< [m^2] self-exchange: the deficit that is only rounding
    std::vector<double> unseen_; ///< [m^2] delta, the other deficits
    double unseen_sum_ = 0.0;    ///< [m^2] sum of delta
};

} // namespace multipath
