#include "sampling/sobol.h"

#include "sampling/sequence.h"

#include <doctest/doctest.h>
#include <map>
#include <set>
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
            CHECK((sobol::direction_numbers()[d][j] >> (63 - j)) == table[j][d]);
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

// The Gray code of n tells which direction numbers are added without carry (Antonov and Saleev). Those of the first
// four dimensions begin with 1/2; 3/4, 1/4, 3/4, 3/4; 5/8, 7/8, 7/8, 3/8.
TEST_CASE("point 0 is the origin, point 1 the centre, and the next are those found by hand")
{
    const auto sequence = make_sequence("sobol", 0);
    CHECK(sequence->item(0) == Item{0, 0, 0, 0});
    CHECK(sequence->item(1) == Item{0.5, 0.5, 0.5, 0.5});
    CHECK(sequence->item(2) == Item{0.25, 0.75, 0.25, 0.25});
    CHECK(sequence->item(3) == Item{0.75, 0.25, 0.75, 0.75});
    CHECK(sequence->item(4) == Item{0.375, 0.625, 0.125, 0.625});
}

} // namespace sobol_test
