#pragma once

#include "transport/exchange/exchange.h"
#include "transport/exchange/exchange_estimate.h"
#include "transport/exchange/pair_matrix.h"

#include <vector>

namespace multipath {

/// Part of each patch's exchange that reaches no other patch [m^2].
struct ExchangeLosses
{
    std::vector<double> escaping;
    std::vector<double> behind;
};

/// The exchange of all pairs in memory.
class DenseExchange : public Exchange
{
public:
    /// Refers to the matrix, whose diagonal must be zero. The self-exchange makes up what the rows lack of row_area.
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

/// Estimates that agree with what is known for certain.
struct Reconciled
{
    PairMatrix<float> exchange;     ///< [m^2]
    std::vector<double> sum_change; ///< [m^2] by how much each row now adds up to less than wanted
};

/// Changes the estimates as little as possible, measured by their variances, so that every row has the sum that it must
/// have [m^2], the area of the patch less what is lost. Symmetric; pairs that are certain stay. `sum_variance` [m^4] is
/// how uncertain each wanted sum is: it takes its part of the change.
Reconciled reconciled(ExchangeEstimate estimate, const std::vector<double>& row_sums,
                      const std::vector<double>& sum_variance, int threads);

} // namespace multipath
