#include "transport/exchange/symmetric_product.h"

#include "sampling/random.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace symmetric_product_test {

using namespace multipath;

namespace {

using Vectors = std::vector<std::vector<double>>;

/// Numbers of both signs, so that sums cancel and a wrong element shows.
double signed_number(std::uint64_t key, std::uint64_t counter)
{
    return 2.0 * bits_to_unit(random_bits(key, counter)) - 1.0;
}

PairMatrix<float> some_matrix(std::uint32_t n)
{
    PairMatrix<float> matrix(n);
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j <= i; ++j)
            matrix.at(i, j) = static_cast<float>(signed_number(n, 1000 * i + j));
    return matrix;
}

Vectors some_vectors(std::size_t count, std::uint32_t n)
{
    Vectors vectors(count, std::vector<double>(n));
    for (std::size_t k = 0; k < count; ++k)
        for (std::uint32_t i = 0; i < n; ++i)
            vectors[k][i] = signed_number(99 + k, i);
    return vectors;
}

} // namespace

// The sizes lie around one and two bands of rows, and around the number of sums made at once. Summing n doubles in
// another order changes them by n 2^-53 of the sum of their magnitudes, at most 4e-14 here.
TEST_CASE("the product is what a plain loop over all pairs gives")
{
    for (const std::uint32_t n : {1u, 2u, 3u, 4u, 5u, 127u, 128u, 129u, 300u}) {
        CAPTURE(n);
        const PairMatrix<float> matrix = some_matrix(n);
        const Vectors vectors = some_vectors(3, n);
        const Vectors products = symmetric_product(matrix, vectors, 2);
        REQUIRE(products.size() == 3);
        double worst = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            REQUIRE(products[k].size() == n);
            for (std::uint32_t i = 0; i < n; ++i) {
                double sum = 0.0;
                double magnitude = 0.0;
                for (std::uint32_t j = 0; j < n; ++j) {
                    const double term = static_cast<double>(matrix.at(i, j)) * vectors[k][j];
                    sum += term;
                    magnitude += std::abs(term);
                }
                worst = std::max(worst, std::abs(products[k][i] - sum) / magnitude);
            }
        }
        CHECK(worst < 1e-12);
    }
}

TEST_CASE("every number of threads gives the same bits of a product, and several vectors the bits of one")
{
    const PairMatrix<float> matrix = some_matrix(300);
    const Vectors vectors = some_vectors(3, 300);
    const Vectors products = symmetric_product(matrix, vectors, 1);
    CHECK(symmetric_product(matrix, vectors, 2) == products);
    CHECK(symmetric_product(matrix, vectors, 7) == products);
    CHECK(symmetric_product(matrix, {vectors[1]}, 2)[0] == products[1]);
}

TEST_CASE("every instruction set gives the same bits of a product")
{
    for (const std::uint32_t n : {1u, 7u, 8u, 9u, 300u}) {
        const PairMatrix<float> matrix = some_matrix(n);
        for (const std::size_t count : {1u, 3u}) {
            const Vectors vectors = some_vectors(count, n);
            const Vectors products = symmetric_product(matrix, vectors, 1);
            for (const RowKernel* kernel : available_row_kernels()) {
                CAPTURE(kernel->name);
                CHECK(symmetric_product(matrix, vectors, 1, *kernel) == products);
            }
        }
    }
}

TEST_CASE("a matrix of no rows has an empty product")
{
    CHECK(symmetric_product(PairMatrix<float>(0), {{}}, 2) == Vectors{{}});
}

} // namespace symmetric_product_test
