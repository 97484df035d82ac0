#include "sampling/radical_inverse.h"

namespace multipath {

namespace {

constexpr std::uint64_t largest_table = 4096; // 32 kB a base: four of them fit the second cache

} // namespace

double radical_inverse(std::uint64_t base, std::uint64_t n)
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

RadicalInverse::RadicalInverse(std::uint64_t base) : base_(base)
{
    std::uint64_t size = base;
    while (size * base <= largest_table)
        size *= base;
    low_.reserve(size);
    for (std::uint64_t n = 0; n < size; ++n)
        low_.push_back(radical_inverse(base, n));
}

double RadicalInverse::high_part(std::uint64_t high_digits) const
{
    return radical_inverse(base_, high_digits) / static_cast<double>(low_.size());
}

} // namespace multipath
