#pragma once

#include "sampling/sequence.h"

#include <array>
#include <cstdint>

namespace multipath {

/// Sobol sequence in the Gray code order of Antonov and Saleev (1979), with the primitive polynomials and starting
/// direction numbers of Numerical Recipes in C, 2nd edition, section 7.7. It has six dimensions and 2^52 points.
namespace sobol {

constexpr int dimensions = 6;
constexpr int index_bits = 52;

/// Direction numbers of one dimension, one for each bit of the Gray code of an index, lowest bit first. They are
/// fixed-point fractions: bit 63 stands for 1/2.
using DirectionNumbers = std::array<std::uint64_t, index_bits>;

/// The direction numbers of all dimensions, by Sobol's recurrence.
extern const std::array<DirectionNumbers, dimensions> direction_numbers;

/// Coordinate of point n as a fixed-point fraction (bit 63 stands for 1/2). n < 2^52, 0 <= dimension < 6.
std::uint64_t coordinate_bits(std::uint64_t n, int dimension);

} // namespace sobol

/// Returns the bits of x in reverse order.
inline std::uint64_t reverse_bits(std::uint64_t x)
{
    x = (x >> 1 & 0x5555555555555555u) | (x & 0x5555555555555555u) << 1;
    x = (x >> 2 & 0x3333333333333333u) | (x & 0x3333333333333333u) << 2;
    x = (x >> 4 & 0x0f0f0f0f0f0f0f0fu) | (x & 0x0f0f0f0f0f0f0f0fu) << 4;
    return __builtin_bswap64(x);
}

/// Owen scrambling (nested uniform scrambling) by hashing, of a fixed-point fraction x whose bits are *reversed* (bit 0
/// stands for 1/2). Whether a bit is flipped depends only on the lower bits and the key: sums and products carry
/// upwards only, and since the multipliers are even, bit i of the product in x ^ (x * even) depends only on the bits of
/// x below i. The method is that of Laine and Karras (Stratified sampling for stochastic transparency, EGSR 2011), here
/// with 64 bits and multipliers of our own choice; how random the flips look depends on the multipliers.
inline std::uint64_t scramble_reversed(std::uint64_t x, std::uint64_t key)
{
    x += key;
    x ^= x * 0x6c50b47cb82f1e52u;
    x += key >> 7 | key << 57;
    x ^= x * 0xc7afe638d22f6e66u;
    x ^= x * 0x3d20adea8d22f6e8u;
    return x;
}

/// Sobol sequence. Its randomisations keep its stratification, the number of points in each elementary interval: a
/// random digital shift (exclusive or with one random number per dimension), or Owen scrambling (Owen 1995), where each
/// bit is flipped at random, depending on all bits before it. Throws std::invalid_argument for more than six
/// dimensions.
std::unique_ptr<Sequence> make_sobol_sequence(const SequenceRequest& request);

} // namespace multipath
