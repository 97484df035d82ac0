#pragma once

#include <cstdint>

namespace multipath {

/// The digits of n in `base` (at least 2) mirrored at the point: n = 6 = 110 in base 2 gives 0.011 = 0.375.
/// Digits are handled as integers and divided once, so the result is the nearest double but for the last bit, in [0,
/// 1). Digits of n beyond the 63rd bit of base^k no longer change a double and are left out.
inline double radical_inverse(std::uint64_t base, std::uint64_t n)
{
    std::uint64_t reversed = 0;
    std::uint64_t power = 1;
    const std::uint64_t limit = (std::uint64_t{1} << 63) / base;
    while (n > 0 && power <= limit) {
        const std::uint64_t quotient = n / base;
        reversed = reversed * base + (n - quotient * base);
        power *= base;
        n = quotient;
    }
    const double value = static_cast<double>(reversed) / static_cast<double>(power);
    return value < 1.0 ? value : 1.0 - 0x1p-53;
}

} // namespace multipath
