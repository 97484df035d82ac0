#include "cli/decimal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace multipath {

namespace {

constexpr std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();

/// Takes the digits at the front of `text` away and returns them.
std::string_view take_digits(std::string_view& text)
{
    const std::string_view digits = text.substr(0, text.find_first_not_of("0123456789"));
    text.remove_prefix(digits.size());
    return digits;
}

bool take(std::string_view& text, char wanted)
{
    const bool found = !text.empty() && text.front() == wanted;
    text.remove_prefix(found ? 1 : 0);
    return found;
}

/// `e6`, `E-3` or nothing. Six digits or more are absent: no double reaches so far.
std::optional<int> take_exponent(std::string_view& text)
{
    if (!take(text, 'e') && !take(text, 'E'))
        return 0;
    const bool negative = take(text, '-');
    if (!negative)
        take(text, '+');
    const std::string_view digits = take_digits(text);
    if (digits.empty() || digits.size() > 5)
        return std::nullopt;
    int exponent = 0;
    for (const char digit : digits)
        exponent = 10 * exponent + (digit - '0');
    return negative ? -exponent : exponent;
}

} // namespace

std::optional<Decimal> parse_decimal(std::string_view text)
{
    if (text.size() > 1000) // keeps the exponent an int
        return std::nullopt;
    Decimal decimal;
    decimal.negative = take(text, '-');
    decimal.digits = take_digits(text);
    if (take(text, '.')) {
        const std::string_view fraction = take_digits(text);
        decimal.digits += fraction;
        decimal.exponent = -static_cast<int>(fraction.size());
    }
    const std::optional<int> exponent = take_exponent(text);
    if (decimal.digits.empty() || !exponent || !text.empty())
        return std::nullopt;
    decimal.exponent += *exponent;

    decimal.digits.erase(0, std::min(decimal.digits.find_first_not_of('0'), decimal.digits.size()));
    while (!decimal.digits.empty() && decimal.digits.back() == '0') {
        decimal.digits.pop_back();
        ++decimal.exponent;
    }
    return decimal;
}

std::optional<std::uint64_t> whole_value(const Decimal& decimal)
{
    if (decimal.digits.empty() && !decimal.negative)
        return 0;
    if (decimal.negative || decimal.exponent < 0) // no trailing zeros are left, so this is a fraction
        return std::nullopt;
    if (decimal.digits.size() + static_cast<std::size_t>(decimal.exponent) > 20)
        return largest;
    std::uint64_t value = 0;
    for (const char digit : decimal.digits + std::string(static_cast<std::size_t>(decimal.exponent), '0')) {
        const std::uint64_t unit = static_cast<std::uint64_t>(digit - '0');
        if (value > (largest - unit) / 10)
            return largest;
        value = 10 * value + unit;
    }
    return value;
}

std::optional<double> real_value(const Decimal& decimal)
{
    if (decimal.digits.empty())
        return 0.0;
    // Some standard libraries read at most 40 characters; what is cut off here is below 1e-29 of the value.
    const std::size_t kept = std::min<std::size_t>(decimal.digits.size(), 30);
    // Without a decimal point the text reads the same in every locale.
    const int exponent = decimal.exponent + static_cast<int>(decimal.digits.size() - kept);
    std::istringstream stream(decimal.digits.substr(0, kept) + "e" + std::to_string(exponent));
    double value = 0.0;
    stream >> value;
    if (stream.fail() || !std::isnormal(value))
        return std::nullopt;
    return decimal.negative ? -value : value;
}

} // namespace multipath
