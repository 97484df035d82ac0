#include "sampling/sobol.h"

#include "sampling/sequence.h"

#include <doctest/doctest.h>
#include <set>

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

TEST_CASE("point 0 is the origin, point 1 the centre")
{
    const auto sequence = make_sequence("sobol", 0);
    CHECK(sequence->item(0) == Item{0, 0, 0, 0});
    CHECK(sequence->item(1) == Item{0.5, 0.5, 0.5, 0.5});
    CHECK(sequence->item(2)[0] == 0.25); // the order of Antonov and Saleev: gray code 11 = 1/2 xor 3/4
    CHECK(sequence->item(3)[0] == 0.75);
}
