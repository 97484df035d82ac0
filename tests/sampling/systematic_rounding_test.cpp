#include "sampling/systematic_rounding.h"

#include "sampling/random.h"

#include <cmath>
#include <doctest/doctest.h>
#include <vector>

namespace systematic_rounding_test {

using namespace multipath;

// For offsets 0, 1/n ... (n - 1)/n a sum that grows by x passes n x whole numbers in all, if n x is whole.
TEST_CASE("each number is rounded up or down, and to itself on the average over the offsets")
{
    constexpr int n = 64;
    std::vector<double> expected;
    for (std::uint64_t k = 0; k < 100; ++k)
        expected.push_back(std::floor(n * 3.0 * bits_to_unit(random_bits(5, k))) / n);
    std::vector<double> sums(expected.size());
    for (int offset = 0; offset < n; ++offset) {
        double sum = static_cast<double>(offset) / n; // exact, as all sums are
        SystematicRounding rounding(sum);
        for (std::size_t k = 0; k < expected.size(); ++k) {
            const auto rounded = static_cast<double>(rounding.up_to(sum += expected[k]));
            CHECK(std::abs(rounded - expected[k]) < 1.0);
            sums[k] += rounded;
        }
        CHECK(static_cast<double>(rounding.given()) == std::floor(sum));
    }
    for (std::size_t k = 0; k < expected.size(); ++k)
        CHECK(sums[k] == n * expected[k]);
}

} // namespace systematic_rounding_test
