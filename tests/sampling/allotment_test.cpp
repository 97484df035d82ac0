#include "sampling/allotment.h"

#include <doctest/doctest.h>

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
            CHECK(allotment.patch_of(ray) == patch);
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
