#include "radiosity/reuse/exchange_solver.h"

#include "linear_system.h"
#include "sampling/random.h"
#include "transport/exchange/dense_exchange.h"

#include <cmath>
#include <doctest/doctest.h>
#include <utility>

namespace exchange_solver_test {

using namespace multipath;

namespace {

using Field = std::vector<Rgb>;

double number(std::uint64_t key, std::uint64_t counter)
{
    return bits_to_unit(random_bits(key, counter));
}

Field some_colours(std::uint64_t key, std::uint32_t n)
{
    Field colours;
    for (std::uint32_t i = 0; i < n; ++i)
        colours.push_back({number(key, 3 * i), number(key, 3 * i + 1), number(key, 3 * i + 2)});
    return colours;
}

PairMatrix<float> some_pairs(std::uint64_t key, std::uint32_t n)
{
    PairMatrix<float> pairs(n);
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < i; ++j)
            pairs.at(i, j) = static_cast<float>(number(key, 1000 * i + j));
    return pairs;
}

/// Rows with the sum of their pairs, a tenth of that as losses and `self` times it as self-exchange.
DenseExchange exchange_of(const PairMatrix<float>& pairs, double self)
{
    ExchangeLosses losses;
    std::vector<double> row_area;
    for (std::uint32_t i = 0; i < pairs.size(); ++i) {
        double sum = 0.0;
        for (std::uint32_t j = 0; j < pairs.size(); ++j)
            sum += static_cast<double>(pairs.at(i, j));
        losses.escaping.push_back(0.06 * sum);
        losses.behind.push_back(0.04 * sum);
        row_area.push_back((1.1 + self) * sum);
    }
    return DenseExchange(pairs, std::move(losses), std::move(row_area), 1);
}

/// One channel of A^_i B_i - rho_i sum over j of G_ij B_j = A^_i S_i, the equation as it stands in the header.
std::vector<double> exact_channel(const DenseExchange& exchange, const PairMatrix<float>& pairs, const Field& rho,
                                  const Field& source, double Rgb::*channel)
{
    const std::uint32_t n = exchange.size();
    std::vector<std::vector<double>> matrix(n, std::vector<double>(n));
    std::vector<double> right(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j)
            matrix[i][j] = -(rho[i].*channel) * static_cast<double>(pairs.at(i, j));
        matrix[i][i] = exchange.row_area(i) - rho[i].*channel * exchange.self_exchange(i);
        right[i] = exchange.row_area(i) * source[i].*channel;
    }
    return solve_dense(matrix, right);
}

void check_solution(const DenseExchange& exchange, const PairMatrix<float>& pairs, const Field& rho,
                    const Field& source, const Field& radiosity)
{
    for (double Rgb::*channel : {&Rgb::r, &Rgb::g, &Rgb::b}) {
        const std::vector<double> exact = exact_channel(exchange, pairs, rho, source, channel);
        for (std::uint32_t i = 0; i < exchange.size(); ++i)
            CHECK(radiosity[i].*channel == doctest::Approx(exact[i]).epsilon(1e-6));
    }
}

/// A cube of side 1: each wall exchanges 0.2 with every other, 0.199825 with the opposite one.
PairMatrix<float> cube()
{
    const double opposite =
        (std::log(4.0 / 3.0) + 4.0 * std::sqrt(2.0) * std::atan(1.0 / std::sqrt(2.0)) - std::acos(-1.0)) /
        std::acos(-1.0);
    PairMatrix<float> pairs(6);
    for (std::uint32_t i = 0; i < 6; ++i)
        for (std::uint32_t j = 0; j < i; ++j)
            pairs.at(i, j) = static_cast<float>(i / 2 == j / 2 ? opposite : 0.25 * (1.0 - opposite));
    return pairs;
}

/// Nothing is lost, and all rows have the same area.
DenseExchange closed(const PairMatrix<float>& pairs, double row_area)
{
    const std::vector<double> none(pairs.size(), 0.0);
    return DenseExchange(pairs, {none, none}, std::vector<double>(pairs.size(), row_area), 1);
}

Field grey(std::uint32_t n, double value)
{
    return Field(n, Rgb{value, value, value});
}

} // namespace

// The solver stops at 1e-9 of the first bounce; the systems are well conditioned (a tenth of the light is lost at every
// bounce), which leaves 1e-8, and the check is at 1e-6. Every third patch is black and every fifth white.
TEST_CASE("the solution is the one of Gaussian elimination, for colours, black and white patches and self-exchange")
{
    for (const double self : {0.0, 0.3, -0.05})
        for (std::uint64_t key = 1; key <= 5; ++key) {
            CAPTURE(self);
            CAPTURE(key);
            const std::uint32_t n = 20;
            const PairMatrix<float> pairs = some_pairs(key, n);
            const DenseExchange exchange = exchange_of(pairs, self);
            Field rho = some_colours(10 + key, n);
            for (std::uint32_t i = 0; i < n; ++i)
                rho[i] = i % 3 == 0 ? Rgb{} : i % 5 == 0 ? Rgb{1, 1, 1} : rho[i];
            rho[1] = {0.0, 1.0, 0.5}; // black in one channel only
            const Field source = some_colours(20 + key, n);
            const ExchangeSolution solution = solve_exchange(exchange, rho, source, source, 2, 1e-9, 200);
            CHECK(solution.converged);
            check_solution(exchange, pairs, rho, source, solution.radiosity);
            for (std::uint32_t i = 0; i < n; i += 3)
                CHECK(solution.radiosity[i] == source[i]);
        }
}

// Every bounce returns the share rho: B = E (1 + rho + rho^2 + ...). The self-exchange takes up the rounding of the
// pairs to float, so that only that of doubles remains.
TEST_CASE("in a closed cube of equal walls the radiosity is E / (1 - rho)")
{
    const PairMatrix<float> pairs = cube();
    for (const double rho : {0.0, 0.3, 0.9, 0.999}) {
        CAPTURE(rho);
        const ExchangeSolution solution =
            solve_exchange(closed(pairs, 1.0), grey(6, rho), grey(6, 2.0), grey(6, 2.0), 1, 1e-12, 50);
        CHECK(solution.converged);
        for (const Rgb b : solution.radiosity)
            CHECK(b.g == doctest::Approx(2.0 / (1.0 - rho)).epsilon(1e-10));
    }
}

// The exchange of a cube has three eigenvalues (all walls alike, opposite walls alike, opposite walls opposite), and
// conjugate gradients take one step for each.
TEST_CASE("whatever its source, a cube of equal walls takes three steps")
{
    const PairMatrix<float> pairs = cube();
    const Field source = {{1, 7, 0}, {2, 0, 0}, {0, 3, 1}, {5, 0, 0}, {1, 1, 0}, {0, 4, 0}};
    CHECK(solve_exchange(closed(pairs, 1.0), grey(6, 0.99), source, source, 1, 1e-6, 3).converged);
    CHECK_FALSE(solve_exchange(closed(pairs, 1.0), grey(6, 0.99), source, source, 1, 1e-6, 2).converged);
}

// One wall is black and takes what the five white ones are lit with.
TEST_CASE("white walls end the light on the one that is not")
{
    const PairMatrix<float> pairs = cube();
    const DenseExchange exchange = closed(pairs, 1.0);
    Field rho = grey(6, 1.0);
    rho[5] = {};
    Field source = grey(6, 0.0);
    source[0] = {1.0, 2.0, 3.0};
    const ExchangeSolution solution = solve_exchange(exchange, rho, source, source, 1, 1e-10, 100);
    CHECK(solution.converged);
    check_solution(exchange, pairs, rho, source, solution.radiosity);
    const Rgb irradiance = exchange.apply(solution.radiosity, 1)[5];
    CHECK(irradiance.r == doctest::Approx(1.0).epsilon(1e-8));
    CHECK(irradiance.b == doctest::Approx(3.0).epsilon(1e-8));
}

TEST_CASE("a patch that no line met keeps its source and leaves the rest alone")
{
    const std::uint32_t n = 12;
    PairMatrix<float> pairs = some_pairs(3, n);
    for (std::uint32_t j = 0; j < n; ++j)
        pairs.at(4, j) = 0.0f;
    const DenseExchange exchange = exchange_of(pairs, 0.1);
    REQUIRE(exchange.row_area(4) == 0.0);
    const Field rho = some_colours(4, n);
    Field source = some_colours(5, n);
    const Field radiosity = solve_exchange(exchange, rho, source, source, 1, 1e-9, 200).radiosity;
    CHECK(radiosity[4] == source[4]);
    source[4] = {100.0, 100.0, 100.0}; // meets nobody
    const ExchangeSolution solution = solve_exchange(exchange, rho, source, source, 1, 1e-9, 200);
    CHECK(solution.converged);
    for (std::uint32_t i = 0; i < n; ++i)
        if (i != 4)
            CHECK(solution.radiosity[i] == radiosity[i]);
}

// Two patches and rho = 0.9 make the matrix ((a - rho g, -rho G), (-rho G, a - rho g)) with g the self-exchange, whose
// eigenvalues are a - rho g - rho G and a - rho g + rho G. The cases have none, one and two below zero.
TEST_CASE("an exchange too noisy for a solution to exist is reported")
{
    const auto converged = [](float pair, double row_area, Field source) {
        PairMatrix<float> pairs(2);
        pairs.at(1, 0) = pair;
        return solve_exchange(closed(pairs, row_area), grey(2, 0.9), source, source, 1, 1e-9, 50).converged;
    };
    const Field even = grey(2, 1.0);
    const Field uneven = {{1, 1, 1}, {0, 0, 0}};
    CHECK(converged(0.5f, 1.0, uneven));        // g = 0.5: 0.1 and 1
    CHECK(converged(-0.01f, 1.0, uneven));      // g = 1.01: a little noise is none
    CHECK_FALSE(converged(-0.1f, 1.0, uneven)); // g = 1.1: 0.1 and -0.08, with a positive diagonal
    CHECK_FALSE(converged(-1.0f, 1.0, uneven)); // g = 2: 0.1 and -1.7
    CHECK_FALSE(converged(-0.2f, 1.0, uneven)); // g = 1.2: 0.1 and -0.26
    CHECK_FALSE(converged(-0.5f, -1.0, even));  // g = -0.5: -0.1 and -1
    CHECK_FALSE(converged(-0.5f, -1.0, uneven));
}

// Random entries between -10 and 10 have eigenvalues of up to some 60 of either sign, against row areas of 10.
TEST_CASE("strongly negative entries do not pass for a solution")
{
    for (std::uint64_t key = 1; key <= 10; ++key) {
        CAPTURE(key);
        PairMatrix<float> pairs = some_pairs(key, 30);
        for (std::uint32_t i = 0; i < 30; ++i)
            for (std::uint32_t j = 0; j < i; ++j)
                pairs.at(i, j) = 20.0f * (pairs.at(i, j) - 0.5f);
        const Field source = some_colours(key, 30);
        const ExchangeSolution solution =
            solve_exchange(closed(pairs, 10.0), grey(30, 0.9), source, source, 1, 1e-9, 500);
        CHECK_FALSE(solution.converged);
    }
}

TEST_CASE("a grey scene has equal bits in all channels, and any number of threads the same")
{
    const PairMatrix<float> pairs = some_pairs(8, 200);
    const DenseExchange exchange = exchange_of(pairs, 0.0);
    Field rho;
    Field source;
    for (std::uint32_t i = 0; i < 200; ++i) {
        rho.push_back(grey(1, number(9, i))[0]);
        source.push_back(grey(1, number(10, i))[0]);
    }
    const Field one = solve_exchange(exchange, rho, source, source, 1, 1e-9, 200).radiosity;
    for (const Rgb b : one)
        CHECK((b.r == b.g && b.g == b.b));
    CHECK(solve_exchange(exchange, rho, source, source, 2, 1e-9, 200).radiosity == one);
    CHECK(solve_exchange(exchange, rho, source, source, 7, 1e-9, 200).radiosity == one);
}

TEST_CASE("a good first guess takes fewer steps, and the solution itself none")
{
    const std::uint32_t n = 50;
    const PairMatrix<float> pairs = some_pairs(11, n);
    const DenseExchange exchange = exchange_of(pairs, 0.0);
    const Field rho = some_colours(12, n);
    const Field source = some_colours(13, n);
    const auto steps_from = [&](const Field& guess) {
        int steps = 0;
        while (steps < 100 && !solve_exchange(exchange, rho, source, guess, 1, 1e-6, steps).converged)
            ++steps;
        return steps;
    };
    const Field exact = solve_exchange(exchange, rho, source, source, 1, 1e-12, 200).radiosity;
    Field good = exact;
    for (std::uint32_t i = 0; i < n; ++i)
        good[i] = exact[i] + 1e-4 * (1.0 - 2.0 * number(14, i)) * (exact[i] - source[i]);
    const int from_source = steps_from(source);
    CHECK(from_source < 100);
    CHECK(steps_from(good) < from_source);
    CHECK(steps_from(exact) == 0);
}

} // namespace exchange_solver_test
