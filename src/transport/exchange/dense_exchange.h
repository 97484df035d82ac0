#pragma once

#include "transport/exchange/exchange.h"
#include "transport/exchange/exchange_estimate.h"
#include "transport/exchange/pair_matrix.h"

#include <vector>

namespace multipath {

/// Exchange areas [m^2] of each patch that lead to no other patch; one number per patch.
struct ExchangeLosses
{
    std::vector<double> escaping; ///< towards nothing
    std::vector<double> behind;   ///< towards backs, sides without a patch
};

/// Exchange with the exchange areas of all pairs of patches in memory.
class DenseExchange : public Exchange
{
public:
    /// Keeps a reference to `pairs` [m^2], whose diagonal must be zero. The self-exchange is what each row, with its
    /// losses, lacks of row_area [m^2]; it is negative for a row that exceeds it.
    DenseExchange(const PairMatrix<float>& pairs, ExchangeLosses losses, std::vector<double> row_area, int threads);

    std::uint32_t size() const override { return pairs_.size(); }
    void multiply(const std::vector<Rgb>& x, int threads, std::vector<Rgb>& y) const override;
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

/// Exchange areas after least-squares closure.
struct ClosedEstimate
{
    PairMatrix<float> exchange;       ///< [m^2]
    std::vector<double> sum_residual; ///< [m^2] per row: the wanted sum minus the sum of the row now
};

/// Enforces closure by least squares (R3), a smoothing of exchange areas as in Larsen and Howell (1986). Of all changes
/// that give each row its sum in `row_sums` [m^2], the area of the patch without its losses, it makes the one with the
/// smallest sum of squares, weighted by the inverse variances. The result is symmetric; pairs of variance 0 keep their
/// values, and so do rows of such pairs whatever their sums. A wanted sum of `sum_variance` > 0 [m^4] is itself an
/// estimate and takes its part of the change.
ClosedEstimate reconciled(ExchangeEstimate estimate, const std::vector<double>& row_sums,
                          const std::vector<double>& sum_variance, int threads);

} // namespace multipath
