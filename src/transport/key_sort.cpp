#include "transport/key_sort.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace multipath {

namespace {

constexpr int digit_bits = 11; // the places of all digits then stay in the first-level cache
constexpr std::size_t digit_values = std::size_t{1} << digit_bits;

using DigitPlaces = std::array<std::uint32_t, digit_values>;

std::size_t digit(std::uint64_t key, int shift)
{
    return static_cast<std::size_t>(key >> shift) & (digit_values - 1);
}

/// Where the keys with each value of the digit begin.
DigitPlaces places_of(const std::vector<std::uint64_t>& keys, int shift)
{
    DigitPlaces places{};
    for (const std::uint64_t key : keys)
        ++places[digit(key, shift)];
    std::uint32_t begin = 0;
    for (std::uint32_t& place : places) {
        const std::uint32_t count = place;
        place = begin;
        begin += count;
    }
    return places;
}

} // namespace

void sort_keys(std::vector<std::uint64_t>& keys, int bits)
{
    // Few keys do not pay for the places; more than 2^32 would not fit into them.
    if (keys.size() < digit_values / 4 || keys.size() > 0xffffffffu) {
        std::sort(keys.begin(), keys.end());
        return;
    }
    std::vector<std::uint64_t> sorted(keys.size());
    for (int shift = 0; shift < bits; shift += digit_bits) {
        DigitPlaces places = places_of(keys, shift);
        for (const std::uint64_t key : keys)
            sorted[places[digit(key, shift)]++] = key;
        keys.swap(sorted);
    }
}

} // namespace multipath
