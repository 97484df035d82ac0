#pragma once

#include <cstdint>

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

} // namespace multipath
