#include "transport/exchange/dense_exchange.h"

#include "sampling/random.h"

#include <doctest/doctest.h>

namespace dense_exchange_test {

using namespace multipath;

namespace {

constexpr std::uint32_t size = 150; // more than one band of the product

double number(std::uint64_t key, std::uint64_t counter)
{
    return bits_to_unit(random_bits(key, counter));
}

PairMatrix<float> some_pairs()
{
    PairMatrix<float> pairs(size);
    for (std::uint32_t i = 0; i < size; ++i)
        for (std::uint32_t j = 0; j < i; ++j)
            pairs.at(i, j) = static_cast<float>(number(1, 1000 * i + j));
    return pairs;
}

std::vector<double> some_numbers(std::uint64_t key)
{
    std::vector<double> numbers;
    for (std::uint32_t i = 0; i < size; ++i)
        numbers.push_back(number(key, i));
    return numbers;
}

} // namespace

// Sums of 150 positive doubles in another order: within 150 * 2^-53 < 1e-12 of each other.
TEST_CASE("applying the exchange is the sum over all patches, itself included")
{
    const PairMatrix<float> pairs = some_pairs();
    const DenseExchange exchange(pairs, {some_numbers(2), some_numbers(3)}, std::vector<double>(size, 100.0), 2);
    std::vector<Rgb> x;
    for (std::uint32_t i = 0; i < size; ++i)
        x.push_back({number(4, i), number(5, i), number(6, i)});
    const std::vector<Rgb> y = exchange.apply(x, 2);
    REQUIRE(exchange.size() == size);
    REQUIRE(y.size() == size);
    for (std::uint32_t i = 0; i < size; ++i) {
        Rgb sum = exchange.self_exchange(i) * x[i];
        for (std::uint32_t j = 0; j < size; ++j)
            if (j != i)
                sum += static_cast<double>(pairs.at(i, j)) * x[j];
        CHECK(y[i].r == doctest::Approx(sum.r).epsilon(1e-12));
        CHECK(y[i].g == doctest::Approx(sum.g).epsilon(1e-12));
        CHECK(y[i].b == doctest::Approx(sum.b).epsilon(1e-12));
    }
    CHECK(exchange.apply(x, 1) == y);
    CHECK(exchange.apply(x, 7) == y);
}

// The areas are smaller than some rows and larger than others, so that the self-exchange has both signs.
TEST_CASE("with the self-exchange and the losses every row adds up to its area")
{
    const PairMatrix<float> pairs = some_pairs();
    std::vector<double> row_area = some_numbers(7);
    for (double& area : row_area)
        area = 50.0 + 50.0 * area;
    const DenseExchange exchange(pairs, {some_numbers(2), some_numbers(3)}, row_area, 2);
    const std::vector<Rgb> rows = exchange.apply(std::vector<Rgb>(size, Rgb{1, 1, 1}), 2);
    int negative = 0;
    for (std::uint32_t i = 0; i < size; ++i) {
        CHECK(exchange.row_area(i) == row_area[i]);
        CHECK(exchange.escaping(i) == number(2, i));
        CHECK(exchange.behind(i) == number(3, i));
        CHECK(rows[i].g + number(2, i) + number(3, i) == doctest::Approx(row_area[i]).epsilon(1e-12));
        negative += exchange.self_exchange(i) < 0.0 ? 1 : 0;
    }
    CHECK((negative > 0 && negative < static_cast<int>(size)));
}

} // namespace dense_exchange_test
