#pragma once

#include <cstdint>

namespace multipath {

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

} // namespace multipath
