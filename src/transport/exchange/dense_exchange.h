#pragma once

#include "transport/exchange/exchange.h"
#include "transport/exchange/exchange_estimate.h"
#include "transport/exchange/pair_counts.h"

#include <vector>

namespace multipath {

/// Exchange areas [m^2] of each patch with everything that is not a patch.
struct ExchangeLosses
{
    std::vector<double> escaping; ///< per patch: exchange area with the outside of the scene
    std::vector<double> behind;   ///< per patch: exchange area with backs (sides that have no patches)
};

/// Exchange areas (exchange.h) as a dense matrix, which has an element in memory for every pair of patches.
class DenseExchange : public Exchange
{
public:
    /// Keeps a reference to `pairs` [m^2], a matrix with zeros on its diagonal. `row_area` [m^2] is per patch. The
    /// self-exchange of a patch becomes its row_area minus the sum of its row and its losses. It is negative if these
    /// exceed the row_area.
    DenseExchange(const PairMatrix<float>& pairs, ExchangeLosses losses, std::vector<double> row_area, int threads);

    std::uint32_t size() const override { return pairs_.size(); }
    std::vector<Rgb> apply(const std::vector<Rgb>& x, int threads) const override;
    double self_exchange(std::uint32_t patch) const override { return self_exchange_[patch]; }
    double escaping(std::uint32_t patch) const override { return losses_.escaping[patch]; }
    double behind(std::uint32_t patch) const override { return losses_.behind[patch]; }
    double row_area(std::uint32_t patch) const override { return row_area_[patch]; }

private:
    const PairMatrix<float>& pairs_;
    ExchangeLosses losses_;
    std::vector<double> row_area_;
    std::vector<double> self_exchange_;
};

/// Enforces closure by least squares ((R3) in docs/equations.md), a smoothing of exchange areas as in Larsen and Howell
/// (1986). The sum wanted of row i is wanted[i] [m^2], the area of the patch minus its losses. Among all symmetric
/// changes that give the rows these sums, makes the one with the smallest sum of squares, weighted by the inverse
/// variances. About 1e-4 of the differences between wanted and present sums remains. A wanted sum with
/// wanted_variance[i] > 0 [m^4] is itself an estimate and takes its part of the change. Pairs of variance 0 keep their
/// values; a row that consists of such pairs does not get its wanted sum. Returns for each row the wanted sum minus the
/// sum of the changed row [m^2], which estimates the error of the wanted sum; 0 for one without variance.
std::vector<double> reconcile(ExchangeEstimate& estimate, const std::vector<double>& wanted,
                              const std::vector<double>& wanted_variance, int threads);

} // namespace multipath
