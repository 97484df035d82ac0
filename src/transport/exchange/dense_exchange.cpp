#include "transport/exchange/dense_exchange.h"

#include "parallel/blocks.h"
#include "transport/exchange/conjugate_gradients.h"
#include "transport/exchange/symmetric_product.h"

#include <utility>

namespace multipath {

DenseExchange::DenseExchange(const PairMatrix<float>& pairs, ExchangeLosses losses, std::vector<double> row_area,
                             int threads)
    : pairs_(pairs), losses_(std::move(losses)), row_area_(std::move(row_area)), self_exchange_(row_area_)
{
    const std::vector<double> sums = row_sums(pairs_, threads);
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
    return parallel_list(n, threads, [&](std::uint32_t i) {
        return Rgb{products[0][i], products[1][i], products[2][i]} + self_exchange_[i] * x[i];
    });
}

// Least-squares closure (R3): minimise the sum of d_ij^2 / var_ij over all pairs, subject to a given sum over j of
// (G_ij + d_ij) for every i. With Lagrange multipliers mu the solution is d_ij = var_ij (mu_i + mu_j). They solve
//
//   (sum over j of var_ij) mu_i + sum over j of var_ij mu_j = deficit of row i,
//
// the wanted sum minus the present one. If a wanted sum is itself uncertain, its variance is added to the first
// bracket. The matrix is symmetric and has no negative eigenvalue, so conjugate gradients solve the system.

std::vector<double> reconcile(ExchangeEstimate& estimate, const std::vector<double>& wanted,
                              const std::vector<double>& wanted_variance, int threads)
{
    using Vector = std::vector<double>;
    constexpr int most_steps = 40;
    constexpr double tolerance = 1e-4; // of the deficit; far finer than the variances are known
    PairMatrix<float>& exchange = estimate.exchange;
    const PairMatrix<float>& variance = estimate.variance;
    const std::uint32_t n = exchange.size();
    const Vector sums = row_sums(exchange, threads);
    Vector diagonal = row_sums(variance, threads);
    Vector deficit(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        const bool can_change = diagonal[i] + wanted_variance[i] > 0.0;
        deficit[i] = can_change ? wanted[i] - sums[i] : 0.0;
        // A tiny addition avoids division by zero.
        diagonal[i] += wanted_variance[i] + 1e-14 * wanted[i] * wanted[i] + 1e-300;
    }
    const auto matrix = [&](const Vector& x) {
        Vector image = symmetric_product(variance, {x}, threads)[0];
        for (std::uint32_t i = 0; i < n; ++i)
            image[i] += diagonal[i] * x[i];
        return image;
    };
    const auto by_diagonal = [&](std::size_t i, double x) { return x / diagonal[i]; };
    const double end = tolerance * tolerance * dot(deficit, deficit);
    const auto done = [&](const Vector& residual, double) { return dot(residual, residual) <= end; };
    Vector multiplier(n);
    conjugate_gradients(matrix, by_diagonal, deficit, most_steps, done, threads, multiplier);

    parallel_blocks(n, threads, [&](std::uint64_t number) {
        const auto i = static_cast<std::uint32_t>(number);
        float* row = exchange.row(i);
        const float* uncertain = variance.row(i);
        for (std::uint32_t j = 0; j < i; ++j)
            row[j] += static_cast<float>(static_cast<double>(uncertain[j]) * (multiplier[i] + multiplier[j]));
    });
    Vector residual = wanted_variance;
    for (std::uint32_t i = 0; i < n; ++i)
        residual[i] *= multiplier[i];
    return residual;
}

} // namespace multipath
