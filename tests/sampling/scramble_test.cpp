#include "sampling/scramble.h"

#include "sampling/random.h"
#include "sampling/sequence.h"

#include <cmath>
#include <doctest/doctest.h>
#include <map>
#include <utility>

namespace scramble_test {

using namespace multipath;

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

} // namespace scramble_test
