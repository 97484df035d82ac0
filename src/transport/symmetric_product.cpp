// Only the lower triangle is stored. Its rows are cut into bands of about equal size, a number that does not depend on
// the threads; each band is read once and gives parts of all products, since an element (i, j) belongs to row i and to
// row j. The parts are added in the order of the bands.

#include "transport/symmetric_product.h"

#include "parallel/ordered_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace multipath {

namespace {

constexpr std::uint32_t bands = 32;
constexpr std::uint32_t lanes = 4; // independent sums, so that several can be made at once

/// Adds row[j] * factor to y[j] and returns the sum of row[j] * x[j], for j < count.
double add_row(const float* row, std::uint32_t count, const double* x, double factor, double* y)
{
    std::array<double, lanes> sums = {};
    std::uint32_t j = 0;
    for (; j + lanes <= count; j += lanes)
        for (std::uint32_t lane = 0; lane < lanes; ++lane) {
            const auto value = static_cast<double>(row[j + lane]);
            sums[lane] += value * x[j + lane];
            y[j + lane] += value * factor;
        }
    for (; j < count; ++j) {
        const auto value = static_cast<double>(row[j]);
        sums[0] += value * x[j];
        y[j] += value * factor;
    }
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/// The first row of a band: the triangle above it holds the share band / bands of all elements.
std::uint32_t first_row(std::uint32_t n, std::uint32_t band)
{
    return static_cast<std::uint32_t>(std::lround(n * std::sqrt(static_cast<double>(band) / bands)));
}

} // namespace

std::vector<std::vector<double>> symmetric_product(const PairMatrix<float>& matrix,
                                                   const std::vector<std::vector<double>>& vectors, int threads)
{
    const std::uint32_t n = matrix.size();
    const std::size_t count = vectors.size();
    std::vector<std::vector<double>> parts(bands * count);
    parallel_blocks(bands, threads, [&](std::uint64_t number) {
        const auto band = static_cast<std::uint32_t>(number);
        const std::uint32_t end = first_row(n, band + 1);
        for (std::size_t k = 0; k < count; ++k)
            parts[band * count + k].resize(end);
        for (std::uint32_t i = first_row(n, band); i < end; ++i)
            for (std::size_t k = 0; k < count; ++k) {
                const double* x = vectors[k].data();
                double* y = parts[band * count + k].data();
                const float* row = matrix.row(i);
                const double below_diagonal = add_row(row, i, x, x[i], y);
                y[i] += below_diagonal + static_cast<double>(row[i]) * x[i];
            }
    });
    std::vector<std::vector<double>> products(count, std::vector<double>(n));
    for (std::uint32_t band = 0; band < bands; ++band)
        for (std::size_t k = 0; k < count; ++k) {
            const std::vector<double>& part = parts[band * count + k];
            for (std::size_t j = 0; j < part.size(); ++j)
                products[k][j] += part[j];
        }
    return products;
}

} // namespace multipath
