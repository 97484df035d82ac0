#include "sampling/allotment.h"

#include "sampling/random.h"

#include <cmath>
#include <doctest/doctest.h>
#include <vector>

namespace allotment_test {

using namespace multipath;

TEST_CASE("rays are numbered patch by patch, and each belongs to one patch")
{
    const Allotment allotment({2.0, 0.0, 0.5, 3.0, 0.0}, 0.75);
    CHECK(allotment.rays() == 6);
    CHECK(allotment.rays_of(0) == 2);
    CHECK(allotment.rays_of(1) == 0);
    CHECK(allotment.rays_of(2) == 1); // 2.75 + 0.5 passes 3
    CHECK(allotment.rays_of(3) == 3);
    CHECK(allotment.rays_of(4) == 0);
    for (std::uint32_t patch = 0; patch < 5; ++patch)
        for (std::uint64_t ray = allotment.first_ray(patch); ray < allotment.first_ray(patch + 1); ++ray)
            CHECK(allotment.recipient_of(ray) == patch);
    CHECK(Allotment(7).rays() == 0);
}

TEST_CASE("on the average over the offset a patch gets what it expects, and a whole number exactly")
{
    const std::vector<double> expected = {0.3, 1.0, 2.6, 0.0, 0.1};
    std::vector<double> sum(expected.size());
    constexpr int offsets = 1000;
    for (int k = 0; k < offsets; ++k) {
        const Allotment allotment(expected, (k + 0.5) / offsets);
        CHECK(allotment.rays_of(1) == 1);
        for (std::uint32_t patch = 0; patch < sum.size(); ++patch)
            sum[patch] += static_cast<double>(allotment.rays_of(patch)) / offsets;
    }
    for (std::uint32_t patch = 0; patch < sum.size(); ++patch)
        CHECK(sum[patch] == doctest::Approx(expected[patch]).epsilon(2e-3));
}

} // namespace allotment_test

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
        const Allotment allotment(expected, sum);
        for (std::uint32_t k = 0; k < expected.size(); ++k) {
            const auto rounded = static_cast<double>(allotment.rays_of(k));
            CHECK(std::abs(rounded - expected[k]) < 1.0);
            sum += expected[k];
            sums[k] += rounded;
        }
        CHECK(static_cast<double>(allotment.rays()) == std::floor(sum));
    }
    for (std::size_t k = 0; k < expected.size(); ++k)
        CHECK(sums[k] == n * expected[k]);
}

} // namespace systematic_rounding_test
