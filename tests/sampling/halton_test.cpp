#include "sampling/halton.h"

#include <array>
#include <cmath>
#include <doctest/doctest.h>

namespace halton_test {

using namespace multipath;

TEST_CASE("radical inverses of small numbers are those found by hand")
{
    const std::array<double, 8> base_2 = {0, 1.0 / 2, 1.0 / 4, 3.0 / 4, 1.0 / 8, 5.0 / 8, 3.0 / 8, 7.0 / 8};
    const std::array<double, 10> base_3 = {0,       1.0 / 3, 2.0 / 3, 1.0 / 9, 4.0 / 9,
                                           7.0 / 9, 2.0 / 9, 5.0 / 9, 8.0 / 9, 1.0 / 27};
    for (std::uint64_t n = 0; n < base_2.size(); ++n)
        CHECK(radical_inverse(2, n) == base_2[n]);
    for (std::uint64_t n = 0; n < base_3.size(); ++n)
        CHECK(radical_inverse(3, n) == base_3[n]);
    CHECK(radical_inverse(17, 1000) == (14.0 * 289 + 7 * 17 + 3) / 4913); // 1000 = 3 * 289 + 7 * 17 + 14
    CHECK(radical_inverse(2, ~0ull) < 1.0);
    CHECK(radical_inverse(19, ~0ull) < 1.0);
}

TEST_CASE("the table of low digits changes no value by more than one unit in the last place")
{
    for (const std::uint64_t base : {2ull, 3ull, 7ull, 19ull, 4099ull}) {
        const RadicalInverse inverse(base);
        for (const std::uint64_t first : {0ull, 4000ull, 123456789ull, (1ull << 45) - 7}) {
            std::uint64_t seen = 0;
            inverse.for_range(first, 10000, [&](std::uint64_t k, double value) {
                CHECK(k == seen++);
                CHECK(value == inverse(first + k));
                const double exact = radical_inverse(base, first + k);
                CHECK(std::abs(value - exact) <= std::nextafter(exact, 2.0) - exact);
                CHECK(value < 1.0);
            });
            CHECK(seen == 10000);
        }
    }
}

} // namespace halton_test
