#pragma once

#include "parallel/mix_bits.h"

#include <cstdint>
#include <cstring>

namespace multipath {

/// Counter-based generator: number `counter` of the stream `key` is a function of the two, so that any part of a
/// stream can be had without the rest. The counter walks by the golden ratio as in SplitMix64.
inline std::uint64_t random_bits(std::uint64_t key, std::uint64_t counter)
{
    return mix_bits(key + 0x9e3779b97f4a7c15u * (counter + 1));
}

/// Uniform in [0, 1): the upper 52 bits become the fraction of a number in [1, 2), which is then shifted down. Exact,
/// and unlike a conversion from integer available in the vector units of every processor.
inline double bits_to_unit(std::uint64_t bits)
{
    const std::uint64_t one_to_two = 0x3ff0000000000000u | bits >> 12;
    double value = 0.0;
    std::memcpy(&value, &one_to_two, sizeof value);
    return value - 1.0;
}

} // namespace multipath
