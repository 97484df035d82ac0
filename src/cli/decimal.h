#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace multipath {

/// A decimal number exactly as written: +-digits * 10^exponent. Zero has no digits; other numbers neither start nor end
/// with 0.
struct Decimal
{
    bool negative = false;
    std::string digits;
    int exponent = 0;
};

/// `-12.5e3` and its parts; nothing else may surround it. Absent for any other text.
std::optional<Decimal> parse_decimal(std::string_view text);

/// Its value when whole and not negative, capped at 2^64 - 1; absent otherwise.
std::optional<std::uint64_t> whole_value(const Decimal& decimal);

/// The nearest double, whatever the locale; absent when out of range.
std::optional<double> real_value(const Decimal& decimal);

} // namespace multipath
