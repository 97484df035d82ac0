#pragma once

#include <cstdint>
#include <cstring>

namespace multipath {

/// Bijective hash of 64 bits in which every input bit affects every output bit, for random numbers and hash tables; 0
/// stays 0. This is the finaliser of SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators,
/// OOPSLA 2014; constants by Stafford).
inline std::uint64_t mix_bits(std::uint64_t x)
{
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// The bits of a number (IEEE 754), to be hashed; -0 counts as 0.
inline std::uint64_t bits_of(double value)
{
    const double without_negative_zero = value + 0.0;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &without_negative_zero, sizeof bits);
    return bits;
}

} // namespace multipath
