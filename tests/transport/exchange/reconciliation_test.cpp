#include "transport/exchange/dense_exchange.h"

#include "sampling/random.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace reconciliation_test {

using namespace multipath;

namespace {

double number(std::uint64_t key, std::uint64_t counter)
{
    return bits_to_unit(random_bits(key, counter));
}

/// Pairs of about 1 / n with variances of about a tenth of their squares, so that rows are about 1; two of seven pairs
/// are certain.
ExchangeEstimate some_estimate(std::uint64_t key, std::uint32_t n)
{
    ExchangeEstimate estimate{PairMatrix<float>(n), PairMatrix<float>(n)};
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < i; ++j) {
            const std::uint64_t counter = 1000 * i + j;
            estimate.exchange.at(i, j) = static_cast<float>(2.0 * number(key, counter) / n);
            const bool certain = (i + 2 * j) % 7 < 2;
            estimate.variance.at(i, j) = certain ? 0.0f : static_cast<float>(0.2 * number(key + 1, counter) / (n * n));
        }
    return estimate;
}

std::vector<double> row_sums(const PairMatrix<float>& pairs)
{
    std::vector<double> sums(pairs.size());
    for (std::uint32_t i = 0; i < pairs.size(); ++i)
        for (std::uint32_t j = 0; j < pairs.size(); ++j)
            sums[i] += static_cast<double>(pairs.at(i, j));
    return sums;
}

std::vector<double> none(std::uint32_t n)
{
    return std::vector<double>(n, 0.0);
}

/// All pairs equally uncertain.
ExchangeEstimate even_estimate(std::uint32_t n, float exchange, float variance)
{
    ExchangeEstimate estimate{PairMatrix<float>(n), PairMatrix<float>(n)};
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < i; ++j) {
            estimate.exchange.at(i, j) = exchange;
            estimate.variance.at(i, j) = variance;
        }
    return estimate;
}

/// The exchange after reconcile().
PairMatrix<float> reconciled(ExchangeEstimate estimate, const std::vector<double>& wanted,
                             const std::vector<double>& variance, int threads)
{
    reconcile(estimate, wanted, variance, threads);
    return estimate.exchange;
}

double change(const ExchangeEstimate& before, const PairMatrix<float>& after, std::uint32_t i, std::uint32_t j)
{
    return static_cast<double>(after.at(i, j)) - static_cast<double>(before.exchange.at(i, j));
}

} // namespace

// The solver stops when the residual, weighted by the rows' variances, is 1e-4 of what was lacking. Rows have similar
// variances here, so the largest error of a row is well below 1e-3 of the largest lack.
TEST_CASE("afterwards every row has the sum that it must have")
{
    for (const std::uint32_t n : {5u, 20u, 130u}) {
        CAPTURE(n);
        const ExchangeEstimate estimate = some_estimate(n, n);
        const std::vector<double> before = row_sums(estimate.exchange);
        std::vector<double> wanted(n);
        double worst = 0.0;
        for (std::uint32_t i = 0; i < n; ++i) {
            wanted[i] = before[i] * (0.9 + 0.2 * number(7, i));
            worst = std::max(worst, std::abs(wanted[i] - before[i]));
        }
        const std::vector<double> after = row_sums(reconciled(estimate, wanted, none(n), 2));
        for (std::uint32_t i = 0; i < n; ++i)
            CHECK(std::abs(after[i] - wanted[i]) < 1e-3 * worst);
    }
}

TEST_CASE("certain pairs stay as they are, and the diagonal empty")
{
    const std::uint32_t n = 20;
    const ExchangeEstimate estimate = some_estimate(1, n);
    const PairMatrix<float> after = reconciled(estimate, std::vector<double>(n, 1.0), none(n), 2);
    int changed = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        CHECK(after.at(i, i) == 0.0f);
        for (std::uint32_t j = 0; j < i; ++j) {
            if (estimate.variance.at(i, j) == 0.0f)
                CHECK(after.at(i, j) == estimate.exchange.at(i, j));
            changed += after.at(i, j) != estimate.exchange.at(i, j) ? 1 : 0;
        }
    }
    CHECK(changed > 100);
}

// At the smallest sum of d_ij^2 / var_ij the quotients d_ij / var_ij are mu_i + mu_j (Karush, Kuhn, Tucker): around any
// four patches the two ways to pair them off have equal sums. Rounding of the exchange to float spoils a quotient by
// some 6e-8 * G / var, 1e-5 here.
TEST_CASE("the changes are the smallest by their variances")
{
    const std::uint32_t n = 5;
    ExchangeEstimate estimate = some_estimate(4, n);
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < i; ++j)
            estimate.variance.at(i, j) = static_cast<float>(0.002 + 0.02 * number(5, 10 * i + j));
    const PairMatrix<float> after = reconciled(estimate, {1.0, 0.8, 1.1, 0.9, 1.2}, none(n), 1);
    const auto quotient = [&](std::uint32_t i, std::uint32_t j) {
        return change(estimate, after, i, j) / static_cast<double>(estimate.variance.at(i, j));
    };
    double largest = 0.0;
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < i; ++j)
            largest = std::max(largest, std::abs(quotient(i, j)));
    CHECK(largest > 1.0);
    for (std::uint32_t left_out = 0; left_out < n; ++left_out) {
        const auto k = [&](std::uint32_t number_of_four) {
            return number_of_four < left_out ? number_of_four : number_of_four + 1;
        };
        const double sum = quotient(k(0), k(1)) + quotient(k(2), k(3));
        CHECK(std::abs(quotient(k(0), k(2)) + quotient(k(1), k(3)) - sum) < 1e-4);
        CHECK(std::abs(quotient(k(0), k(3)) + quotient(k(1), k(2)) - sum) < 1e-4);
    }
}

// By symmetry of the patches 0, 1 and of 2, 3: pairs of equal importance change in proportion to their variances.
TEST_CASE("the more uncertain pair changes more")
{
    ExchangeEstimate estimate = even_estimate(4, 0.25f, 0.001f);
    estimate.variance.at(0, 1) = 0.004f;
    estimate.variance.at(2, 3) = 0.004f;
    const PairMatrix<float> after = reconciled(estimate, std::vector<double>(4, 0.9), none(4), 1);
    CHECK(change(estimate, after, 0, 1) == doctest::Approx(0.15 * 4.0 / 6.0).epsilon(1e-5));
    CHECK(change(estimate, after, 0, 2) == doctest::Approx(0.15 * 1.0 / 6.0).epsilon(1e-5));
}

TEST_CASE("rows that are right already stay to the last bit")
{
    const std::uint32_t n = 20;
    ExchangeEstimate estimate = some_estimate(6, n);
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < i; ++j) // few digits, so that the sums are exact in any order
            estimate.exchange.at(i, j) = std::round(1024.0f * estimate.exchange.at(i, j)) / 1024.0f;
    const PairMatrix<float> after = reconciled(estimate, row_sums(estimate.exchange), none(n), 2);
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < i; ++j)
            CHECK(after.at(i, j) == estimate.exchange.at(i, j));
}

// n equal patches, pairs of variance v, sums of variance s: mu = l / (2 (n - 1) v + s) for what each row lacks, l.
TEST_CASE("an uncertain sum leaves its share of the lack where it is")
{
    for (const double s : {0.0, 0.01, 0.04, 1.0}) {
        CAPTURE(s);
        const double v = 0.01;
        const ExchangeEstimate estimate = even_estimate(4, 0.25f, static_cast<float>(v));
        const PairMatrix<float> after =
            reconciled(estimate, std::vector<double>(4, 1.05), std::vector<double>(4, s), 1);
        for (const double sum : row_sums(after))
            CHECK(sum == doctest::Approx(0.75 + 0.3 * 6.0 * v / (6.0 * v + s)).epsilon(1e-5));
    }
}

// Patch 4, a covered piece of floor, exchanges next to nothing, and of that it is nearly certain; patch 5 sees nobody.
// How much they lack, by their own variances, is no measure of what the rows of the others may be left with.
TEST_CASE("rows that are hard or impossible to mend do not spoil the others")
{
    for (const float variance : {0.0f, 1e-12f, 1e-8f}) {
        CAPTURE(variance);
        ExchangeEstimate estimate = even_estimate(6, 0.3f, 0.001f);
        for (std::uint32_t j = 0; j < 6; ++j) {
            estimate.exchange.at(4, j) = variance > 0.0f && j < 4 ? 0.001f : 0.0f;
            estimate.variance.at(4, j) = j < 4 ? variance : 0.0f;
            estimate.exchange.at(5, j) = 0.0f;
            estimate.variance.at(5, j) = 0.0f;
        }
        const std::vector<double> sums = row_sums(reconciled(estimate, std::vector<double>(6, 1.0), none(6), 1));
        for (std::uint32_t i = 0; i < 4; ++i)
            CHECK(sums[i] == doctest::Approx(1.0).epsilon(1e-3));
        CHECK(sums[5] == 0.0);
    }
}

// Two patches that see only each other want different sums, each of variance s: least squares give the pair
// v (l_0 + l_1) / (2 v + s) of what they lack.
TEST_CASE("uncertain sums that contradict each other are met halfway")
{
    for (const double s : {0.001, 0.01}) {
        CAPTURE(s);
        const ExchangeEstimate estimate = even_estimate(2, 0.5f, 0.01f);
        const PairMatrix<float> after = reconciled(estimate, {0.6, 0.8}, {s, s}, 1);
        CHECK(change(estimate, after, 0, 1) == doctest::Approx(0.01 * 0.4 / (0.02 + s)).epsilon(1e-3));
    }
}

TEST_CASE("every number of threads reconciles to the same bits")
{
    const std::uint32_t n = 200;
    const ExchangeEstimate estimate = some_estimate(2, n);
    const std::vector<double> wanted(n, 1.0);
    const PairMatrix<float> one = reconciled(estimate, wanted, none(n), 1);
    for (const int threads : {2, 7}) {
        const PairMatrix<float> more = reconciled(estimate, wanted, none(n), threads);
        CHECK(std::equal(one.row(0), one.row(n), more.row(0)));
    }
}

} // namespace reconciliation_test
