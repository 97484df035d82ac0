#pragma once

#include "transport/exchange.h"
#include "transport/pair_matrix.h"

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

} // namespace multipath
