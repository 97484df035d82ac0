#include "sampling/warp_kernel.h"

#include "sampling/random.h"
#include "sampling/sequence.h"
#include "sampling/warp.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <string>

namespace warp_kernel_test {

using namespace multipath;

namespace {

/// Numbers at which something happens: ends of the interval and of the quarters of the circle, halves between them,
/// their neighbours; then random ones and those of a net.
std::vector<double> interesting_numbers()
{
    std::vector<double> numbers = {0.0, 0x1p-52, 1e-300, 1.0 - 0x1p-53};
    for (int eighths = 1; eighths < 8; ++eighths)
        for (const double beside : {-0x1p-53, -0x1p-50, 0.0, 0x1p-50, 0x1p-53})
            numbers.push_back(eighths / 8.0 + beside);
    const auto sobol = make_sequence("sobol", 1);
    for (std::uint64_t n = 0; n < 2000; ++n) {
        numbers.push_back(bits_to_unit(random_bits(3, n)));
        numbers.push_back(sobol->coordinate(n, 2));
    }
    return numbers;
}

/// Does the kernel's map give for every pair of the numbers what the map for one point gives?
bool agrees(WarpKernel::Map map, Vec3 (*one)(double, double), const std::vector<double>& numbers)
{
    std::vector<Item> items(numbers.size());
    WarpedPoints points;
    for (std::size_t shift = 0; shift < 40; ++shift)
        for (const std::size_t first : {0u, 2u}) {
            for (std::size_t k = 0; k < numbers.size(); ++k) {
                items[k][first] = numbers[k];
                items[k][first + 1] = numbers[(k + shift * 97) % numbers.size()];
            }
            for (std::size_t k = 0; k < numbers.size(); ++k) {
                if (k % warp_block == 0)
                    map(&items[k], std::min(warp_block, numbers.size() - k), first, points);
                if (one(items[k][first], items[k][first + 1]) != points[k % warp_block])
                    return false;
            }
        }
    return true;
}

} // namespace

TEST_CASE("the maps of every instruction set are those for one point, bit for bit")
{
    const std::vector<double> numbers = interesting_numbers();
    std::vector<std::string> names;
    for (const WarpKernel* kernel : available_warp_kernels()) {
        CAPTURE(kernel->name);
        CHECK(agrees(kernel->uniform_sphere, square_to_uniform_sphere, numbers));
        CHECK(agrees(kernel->cosine_hemisphere, square_to_cosine_hemisphere, numbers));
        names.emplace_back(kernel->name);
    }
    CHECK(names.back() == "plain");
    CHECK(warp_kernel().name == names.front());
}

} // namespace warp_kernel_test
