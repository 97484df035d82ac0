#pragma once

#include "sampling/sequence.h"

#include <array>
#include <cstdint>

namespace multipath {

/// Sobol's sequence in the order of Antonov and Saleev, with the primitive polynomials and starting direction numbers
/// of Numerical Recipes in C, 2nd edition, section 7.7. Six dimensions; indices below 2^52.
namespace sobol {

constexpr int dimensions = 6;
constexpr int index_bits = 52;

/// Direction numbers of one dimension; bit 63 stands for 1/2.
using DirectionNumbers = std::array<std::uint64_t, index_bits>;

/// Computed from the recurrence, once.
const std::array<DirectionNumbers, dimensions>& direction_numbers();

/// Coordinate of point n as a fixed-point number below 1 (bit 63 stands for 1/2). n < 2^52, 0 <= dimension < 6.
std::uint64_t coordinate_bits(std::uint64_t n, int dimension);

} // namespace sobol

inline std::uint64_t reverse_bits(std::uint64_t x)
{
    x = (x >> 1 & 0x5555555555555555u) | (x & 0x5555555555555555u) << 1;
    x = (x >> 2 & 0x3333333333333333u) | (x & 0x3333333333333333u) << 2;
    x = (x >> 4 & 0x0f0f0f0f0f0f0f0fu) | (x & 0x0f0f0f0f0f0f0f0fu) << 4;
#if defined(__GNUC__)
    return __builtin_bswap64(x);
#else
    x = (x >> 8 & 0x00ff00ff00ff00ffu) | (x & 0x00ff00ff00ff00ffu) << 8;
    x = (x >> 16 & 0x0000ffff0000ffffu) | (x & 0x0000ffff0000ffffu) << 16;
    return x >> 32 | x << 32;
#endif
}

/// Nested uniform scrambling of a fixed-point fraction whose bits are *reversed* (bit 0 stands for 1/2): each bit is
/// flipped depending on the lower ones and the key. Sums and products carry only upwards, and x ^ (x * even) leaves the
/// lowest bit in place, so this holds by construction; that the flips look random is the hash's quality (after Laine
/// and Karras, Stratified sampling for stochastic transparency, EGSR 2011; here with 64 bits and multipliers of our own
/// choice).
inline std::uint64_t scramble_reversed(std::uint64_t x, std::uint64_t key)
{
    x += key;
    x ^= x * 0x6c50b47cb82f1e52u;
    x += key >> 7 | key << 57;
    x ^= x * 0xc7afe638d22f6e66u;
    x ^= x * 0x3d20adea8d22f6e8u;
    return x;
}

/// How the points of Sobol's sequence are made random; every kind keeps the elementary intervals that they fill.
enum class SobolKind {
    plain,
    shift, ///< one random number per dimension is added digit by digit (exclusive or)
    owen, ///< every digit is flipped at random depending on all digits before it (nested uniform scrambling, Owen 1995)
};

/// At most six dimensions. Throws std::invalid_argument for more.
std::unique_ptr<Sequence> make_sobol_sequence(SobolKind kind, std::uint64_t seed, int dimensions);

} // namespace multipath
