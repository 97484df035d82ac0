#include "transport/dense_exchange.h"

#include "transport/symmetric_product.h"

#include <utility>

namespace multipath {

DenseExchange::DenseExchange(const PairMatrix<float>& pairs, ExchangeLosses losses, std::vector<double> row_area,
                             int threads)
    : pairs_(pairs), losses_(std::move(losses)), row_area_(std::move(row_area)), self_exchange_(row_area_)
{
    const std::vector<double> ones(size(), 1.0);
    const std::vector<double> sums = symmetric_product(pairs_, {ones}, threads)[0];
    for (std::uint32_t i = 0; i < size(); ++i)
        self_exchange_[i] -= sums[i] + losses_.escaping[i] + losses_.behind[i];
}

std::vector<Rgb> DenseExchange::apply(const std::vector<Rgb>& x, int threads) const
{
    const std::uint32_t n = size();
    std::vector<std::vector<double>> channels(3, std::vector<double>(n));
    for (std::uint32_t i = 0; i < n; ++i) {
        channels[0][i] = x[i].r;
        channels[1][i] = x[i].g;
        channels[2][i] = x[i].b;
    }
    const std::vector<std::vector<double>> products = symmetric_product(pairs_, channels, threads);
    std::vector<Rgb> y(n);
    for (std::uint32_t i = 0; i < n; ++i)
        y[i] = Rgb{products[0][i], products[1][i], products[2][i]} + self_exchange_[i] * x[i];
    return y;
}

} // namespace multipath
