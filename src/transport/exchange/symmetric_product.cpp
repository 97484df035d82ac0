// Only the lower triangle is stored, so each element (i, j) contributes to y_i and, mirrored, to y_j. The rows are cut
// into 32 bands with about equal numbers of elements, whatever the number of threads. Each band is read once and gives
// partial sums of all products; these are added in the order of the bands, so the result has the same bits for any
// number of threads.

#include "transport/exchange/symmetric_product.h"

#include "parallel/blocks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace multipath {

namespace {

constexpr std::uint32_t bands = 32;

/// The first row of a band: the triangle of the rows before it holds the share band / bands of all elements.
std::uint32_t first_row(std::uint32_t n, std::uint32_t band)
{
    return static_cast<std::uint32_t>(std::lround(n * std::sqrt(static_cast<double>(band) / bands)));
}

} // namespace

std::vector<std::vector<double>> symmetric_product(const PairMatrix<float>& matrix,
                                                   const std::vector<std::vector<double>>& vectors, int threads,
                                                   const RowKernel& kernel)
{
    const std::uint32_t n = matrix.size();
    const std::size_t count = vectors.size();
    const auto multiply_row = count == 3 ? kernel.multiply_three : kernel.multiply_one;
    std::vector<std::vector<double>> parts(bands * count);
    parallel_blocks(bands, threads, [&](std::uint64_t number) {
        const auto band = static_cast<std::uint32_t>(number);
        const std::uint32_t end = first_row(n, band + 1);
        for (std::size_t k = 0; k < count; ++k)
            parts[band * count + k].resize(end);
        std::vector<RowProduct> row_products(count);
        for (std::uint32_t i = first_row(n, band); i < end; ++i) {
            for (std::size_t k = 0; k < count; ++k)
                row_products[k] = {vectors[k].data(), vectors[k][i], parts[band * count + k].data()};
            multiply_row(matrix.row(i), i, row_products.data());
        }
    });
    std::vector<std::vector<double>> products(count, std::vector<double>(n));
    constexpr std::uint32_t columns_at_a_time = 1024;
    parallel_ranges(n, columns_at_a_time, threads, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t band = 0; band < bands; ++band)
            for (std::size_t k = 0; k < count; ++k) {
                const std::vector<double>& part = parts[band * count + k];
                for (std::size_t j = first; j < std::min<std::size_t>(end, part.size()); ++j)
                    products[k][j] += part[j];
            }
    });
    return products;
}

std::vector<double> row_sums(const PairMatrix<float>& matrix, int threads)
{
    return symmetric_product(matrix, {std::vector<double>(matrix.size(), 1.0)}, threads)[0];
}

} // namespace multipath
