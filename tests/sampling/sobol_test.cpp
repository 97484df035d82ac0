#include "sampling/random.h"
#include "sampling/sequence.h"
#include "sampling/sobol.h"

#include <cmath>
#include <doctest/doctest.h>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace sobol_test {

using namespace multipath;

// Numerical Recipes in C, 2nd edition, section 7.7 tabulates the odd starting numbers m_1 ... m_4 of all six
// dimensions, including those that the recurrence gives (below the diagonal of the degrees). m_j = v_j 2^j.
TEST_CASE("the direction numbers are those of Numerical Recipes")
{
    const std::uint64_t table[4][6] = {
        {1, 1, 1, 1, 1, 1}, {3, 1, 3, 3, 1, 1}, {5, 7, 7, 3, 3, 5}, {15, 11, 5, 15, 13, 9}};
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t d = 0; d < 6; ++d)
            CHECK((sobol::direction_numbers[d][j] >> (63 - j)) == table[j][d]);
}

// In one dimension the first 2^k points are the multiples of 2^-k in some order, for every dimension: (0, 1)-sequences.
TEST_CASE("every coordinate alone visits each interval of length 2^-k once")
{
    for (int d = 0; d < sobol::dimensions; ++d)
        for (const std::uint64_t block :
             {0ull, 1ull, 5ull}) { // every block of 2^k successive points, not only the first
            std::set<std::uint64_t> intervals;
            for (std::uint64_t n = 0; n < 1024; ++n)
                intervals.insert(sobol::coordinate_bits(1024 * block + n, d) >> 54);
            CHECK(intervals.size() == 1024);
        }
}

namespace {

/// Do the points block * 2^m ... (block + 1) * 2^m - 1 put 2^t points into each elementary interval of volume 2^(t -
/// m)? Such an interval has 2^k_i parts along dimension i, with k_1 + k_2 + ... = m - t; all shapes are tried.
bool fills_intervals(const std::vector<int>& dims, int m, int t, std::uint64_t block)
{
    std::vector<int> shape(dims.size(), 0);
    shape[0] = m - t;
    while (true) {
        std::map<std::vector<std::uint64_t>, int> points;
        for (std::uint64_t n = block << m; n < (block + 1) << m; ++n) {
            std::vector<std::uint64_t> interval;
            for (std::size_t i = 0; i < dims.size(); ++i)
                interval.push_back(shape[i] == 0 ? 0 : sobol::coordinate_bits(n, dims[i]) >> (64 - shape[i]));
            ++points[interval];
        }
        if (points.size() != std::size_t{1} << (m - t))
            return false;
        for (const auto& entry : points)
            if (entry.second != 1 << t)
                return false;
        // The next way to write m - t as an ordered sum.
        std::size_t i = 0;
        while (i + 1 < shape.size() && shape[i] == 0)
            ++i;
        if (i + 1 == shape.size())
            return true;
        const int moved = shape[i] - 1;
        shape[i] = 0;
        shape[0] = moved;
        ++shape[i + 1];
    }
}

} // namespace

// Sobol (1967): with primitive polynomials of degrees g_i the points are a (t, s)-sequence with t = sum (g_i - 1),
// whatever the starting numbers. The degrees here are 1, 2, 3, 3, 4, 4.
TEST_CASE("every elementary interval that theory promises is filled evenly, in any block of 2^m points")
{
    const int degree[6] = {1, 2, 3, 3, 4, 4};
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < i; ++j)
            for (const std::uint64_t block : {0ull, 3ull})
                CHECK(fills_intervals({j, i}, 9, degree[i] + degree[j] - 2, block));
    CHECK(fills_intervals({0, 1, 2}, 9, 3, 0));
    CHECK(fills_intervals({0, 1, 2, 3}, 10, 5, 0));
    CHECK(fills_intervals({0, 1, 2, 3}, 10, 5, 7));
    CHECK(fills_intervals({0, 1, 2, 3, 4, 5}, 13, 11, 0));
}

TEST_CASE("finer intervals than promised are not filled evenly by these direction numbers")
{
    CHECK(!fills_intervals({0, 1}, 8, 0, 0));
    CHECK(!fills_intervals({0, 1, 2, 3}, 10, 0, 0));
}

TEST_CASE("point 0 is the origin, point 1 the centre")
{
    const auto sequence = make_sequence("sobol", 0);
    CHECK(sequence->item(0) == Item{0, 0, 0, 0});
    CHECK(sequence->item(1) == Item{0.5, 0.5, 0.5, 0.5});
    CHECK(sequence->item(2)[0] == 0.25); // the order of Antonov and Saleev: gray code 11 = 1/2 xor 3/4
    CHECK(sequence->item(3)[0] == 0.75);
}

TEST_CASE("reversing bits is its own inverse and moves each bit to its mirror place")
{
    for (int bit = 0; bit < 64; ++bit)
        CHECK(reverse_bits(std::uint64_t{1} << bit) == std::uint64_t{1} << (63 - bit));
    CHECK(reverse_bits(reverse_bits(0x0123456789abcdefu)) == 0x0123456789abcdefu);
}

// Nested uniform: two fractions that agree in their first k digits agree in the first k after scrambling, and if they
// differ in digit k, they differ there afterwards too (reversed, digit k is bit k).
TEST_CASE("scrambling keeps common leading digits common, and the first difference a difference")
{
    for (std::uint64_t trial = 0; trial < 20000; ++trial) {
        const std::uint64_t key = random_bits(1, trial);
        const std::uint64_t x = random_bits(2, trial);
        const auto bit = static_cast<int>(random_bits(3, trial) % 64);
        const std::uint64_t low = (std::uint64_t{1} << bit) - 1;
        const std::uint64_t y = (x & low) | (~x & (low + 1)) | (random_bits(4, trial) & ~low & ~(low + 1));
        const std::uint64_t difference = scramble_reversed(x, key) ^ scramble_reversed(y, key);
        CHECK((difference & low) == 0);
        CHECK((difference >> bit & 1u) == 1u);
    }
}

// A flip of a digit depends on the digits before it: over all 2^12 beginnings and many keys, digit 12 is flipped half
// of the time, and independently of the flip of the neighbouring beginning. Binomial, 4 standard deviations.
TEST_CASE("the flips look random")
{
    constexpr int digit = 12;
    constexpr std::uint64_t beginnings = 1u << digit;
    double flips = 0.0;
    double equal_neighbours = 0.0;
    double count = 0.0;
    for (std::uint64_t key_number = 0; key_number < 40; ++key_number) {
        const std::uint64_t key = random_bits(77, key_number);
        std::uint64_t last = 0;
        for (std::uint64_t b = 0; b < beginnings; ++b) {
            const std::uint64_t flip = scramble_reversed(b, key) >> digit & 1u;
            flips += static_cast<double>(flip);
            equal_neighbours += flip == last ? 1.0 : 0.0;
            last = flip;
            count += 1.0;
        }
    }
    CHECK(std::abs(flips / count - 0.5) < 4.0 * 0.5 / std::sqrt(count));
    CHECK(std::abs(equal_neighbours / count - 0.5) < 4.0 * 0.5 / std::sqrt(count));
}

// What makes a net stays a net. The quality parameter of the first two dimensions is t = 1 (see sobol_test): of 2^8
// points, two lie in each elementary interval of area 2^-7, of all eight shapes.
TEST_CASE("shifted and scrambled points keep the elementary intervals")
{
    for (const char* name : {"sobol", "sobol-shift", "sobol-owen"})
        for (const std::uint64_t seed : {1ull, 2ull, 3ull}) {
            const auto sequence = make_sequence(name, seed, 2);
            for (int shape = 0; shape <= 7; ++shape) {
                std::map<std::pair<int, int>, int> points;
                for (std::uint64_t n = 0; n < 256; ++n)
                    ++points[{static_cast<int>(std::ldexp(sequence->coordinate(n, 0), shape)),
                              static_cast<int>(std::ldexp(sequence->coordinate(n, 1), 7 - shape))}];
                REQUIRE(points.size() == 128);
                for (const auto& interval : points)
                    CHECK(interval.second == 2);
            }
        }
}

// Known answers, computed by whole numbers of any size modulo 2^64: other ones would change the results of every
// randomised run from one version to the next.
TEST_CASE("scrambling gives known answers")
{
    CHECK(scramble_reversed(0, 0x243f6a8885a308d3u) == 0x119020d8a60ca742u);
    CHECK(scramble_reversed(1, 0x243f6a8885a308d3u) == 0x9ef2cb6b9afc445bu);
    CHECK(scramble_reversed(0x0123456789abcdefu, 0x13198a2e03707344u) == 0x47daad79504af281u);
}

} // namespace sobol_test
