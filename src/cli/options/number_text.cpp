// A number is first parsed into decimal digits and an exponent (Decimal), so that whole numbers stay exact, and
// suffixes and percent signs only change the exponent. Only functions for real numbers convert the result to a double.

#include "cli/options/number_text.h"

#include "base/errors.h"
#include "cli/options/choices.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace multipath {

namespace {

constexpr std::uint64_t beyond_count = std::numeric_limits<std::uint64_t>::max();

/// A decimal number exactly as written: +-digits * 10^exponent. Zero has no digits; other numbers neither start nor end
/// with 0.
struct Decimal
{
    bool negative = false;
    std::string digits;
    int exponent = 0;
};

/// Removes the digits at the front of `text` and returns them.
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

/// Removes an exponent such as `e6` or `E-3` and returns it; 0 if there is none. Nothing if it is malformed or has six
/// digits or more, beyond any double.
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

/// Parses `-12.5e3`, without anything around it. Nothing for any other text.
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

/// The value of a whole number that is not negative, at most 2^64 - 1 (larger ones become that); nothing for others.
std::optional<std::uint64_t> whole_value(const Decimal& decimal)
{
    if (decimal.digits.empty() && !decimal.negative)
        return 0;
    if (decimal.negative || decimal.exponent < 0) // a fraction, since trailing zeros have been removed
        return std::nullopt;
    if (decimal.digits.size() + static_cast<std::size_t>(decimal.exponent) > 20)
        return beyond_count;
    std::uint64_t value = 0;
    for (const char digit : decimal.digits + std::string(static_cast<std::size_t>(decimal.exponent), '0')) {
        const std::uint64_t unit = static_cast<std::uint64_t>(digit - '0');
        if (value > (beyond_count - unit) / 10)
            return beyond_count;
        value = 10 * value + unit;
    }
    return value;
}

/// The nearest double; nothing if it is out of range or subnormal.
std::optional<double> real_value(const Decimal& decimal)
{
    if (decimal.digits.empty())
        return 0.0;
    const std::string text = decimal.digits + "e" + std::to_string(decimal.exponent);
    const double value = std::strtod(text.c_str(), nullptr); // no locale is set
    if (!std::isnormal(value))
        return std::nullopt;
    return decimal.negative ? -value : value;
}

[[noreturn]] void refuse(std::string_view option, const std::string& expected, std::string_view text)
{
    throw UsageError(std::string(option) + ": expected " + expected + ", got " + quoted_argument(text));
}

/// The value of `2^20`, at most 2^64 - 1 (larger ones become that). Nothing unless both sides are plain whole numbers.
std::optional<std::uint64_t> power_value(std::string_view text)
{
    const std::size_t caret = text.find('^');
    if (caret == std::string_view::npos || text.find_first_not_of("0123456789^") != std::string_view::npos)
        return std::nullopt;
    const std::optional<Decimal> base_text = parse_decimal(text.substr(0, caret));
    const std::optional<Decimal> exponent_text = parse_decimal(text.substr(caret + 1));
    if (!base_text || !exponent_text)
        return std::nullopt;
    const std::uint64_t base = *whole_value(*base_text);
    const std::uint64_t exponent = std::min<std::uint64_t>(*whole_value(*exponent_text), 64); // enough to reach the cap
    std::uint64_t value = 1;
    for (std::uint64_t i = 0; i < exponent; ++i) {
        if (base != 0 && value > beyond_count / base)
            return beyond_count;
        value *= base;
    }
    return value;
}

/// Parses `1e6` or `1.5M`. M and G only in upper case: `1m` could mean a thousandth.
std::optional<Decimal> decimal_with_suffix(std::string_view text)
{
    const char last = text.empty() ? '\0' : text.back();
    const int thousands = last == 'k' || last == 'K' ? 1 : last == 'M' ? 2 : last == 'G' ? 3 : 0;
    if (thousands > 0)
        text.remove_suffix(1);
    std::optional<Decimal> decimal = parse_decimal(text);
    if (decimal)
        decimal->exponent += 3 * thousands;
    return decimal;
}

std::optional<std::uint64_t> count_value(std::string_view text)
{
    if (const std::optional<std::uint64_t> power = power_value(text))
        return power;
    const std::optional<Decimal> decimal = decimal_with_suffix(text);
    return decimal ? whole_value(*decimal) : std::nullopt;
}

std::optional<double> number_value(std::string_view text)
{
    if (const std::optional<std::uint64_t> power = power_value(text))
        return *power <= largest_count ? std::optional<double>(static_cast<double>(*power)) : std::nullopt;
    const std::optional<Decimal> decimal = decimal_with_suffix(text);
    return decimal ? real_value(*decimal) : std::nullopt;
}

std::string shortest(double value)
{
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    stream << value;
    return stream.str();
}

/// "from 1 to 64", "of at least 1" or "of at most 64".
std::string range_words(const std::string& low, const std::string& high, bool low_is_free, bool high_is_free)
{
    if (high_is_free)
        return " of at least " + low;
    return low_is_free ? " of at most " + high : " from " + low + " to " + high;
}

struct Unit
{
    std::string_view name;
    double factor;
};

/// The value of a number that is followed by one of the units; nothing for any other text. Suffixes such as k, M and G
/// count only if they are among the units.
std::optional<double> value_with_unit(std::string_view text, const std::vector<Unit>& units)
{
    const std::size_t number_length = std::min(text.find_last_of("0123456789.") + 1, text.size());
    const std::string_view name = text.substr(number_length);
    const std::string_view number = text.substr(0, number_length);
    for (const Unit& unit : units) {
        if (unit.name != name)
            continue;
        const std::optional<double> value = number_value(number);
        return value ? std::optional<double>(*value * unit.factor) : std::nullopt;
    }
    return std::nullopt;
}

std::vector<std::string_view> split(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    std::size_t start = 0;
    for (std::size_t end = text.find(separator); end != std::string_view::npos; end = text.find(separator, start)) {
        parts.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    parts.push_back(text.substr(start));
    return parts;
}

} // namespace

std::uint64_t read_count(std::string_view option, std::string_view text, std::uint64_t low, std::uint64_t high)
{
    const std::optional<std::uint64_t> value = count_value(text);
    if (!value)
        refuse(option, "a count such as 1000000, 1e6, 1M or 2^20", text);
    if (*value < low || *value > high)
        refuse(option,
               "a count" + range_words(std::to_string(low), high == largest_count ? "2^63" : std::to_string(high),
                                       low == 0, *value < low && high == largest_count),
               text);
    return *value;
}

double read_real(std::string_view option, std::string_view text, double low, double high)
{
    const std::optional<double> value = number_value(text);
    if (!value)
        refuse(option, "a number such as 0.5, 1e-3 or 2M", text);
    if (*value < low || *value > high)
        refuse(option,
               "a number" + range_words(shortest(low), shortest(high), low == std::numeric_limits<double>::lowest(),
                                        high == std::numeric_limits<double>::max()),
               text);
    return *value;
}

double read_positive(std::string_view option, std::string_view text)
{
    const std::optional<double> value = number_value(text);
    if (!value || *value <= 0.0)
        refuse(option, "a number above zero such as 0.5, 1e-3 or 2M", text);
    return *value;
}

double read_share(std::string_view option, std::string_view text)
{
    const bool percent = !text.empty() && text.back() == '%';
    std::optional<Decimal> decimal = parse_decimal(text.substr(0, text.size() - (percent ? 1 : 0)));
    if (decimal && percent)
        decimal->exponent -= 2;
    const std::optional<double> value = decimal ? real_value(*decimal) : std::nullopt;
    if (!value || decimal->negative || *value > 1.0 || (*value == 1.0 && !percent))
        refuse(option, "a share such as 1% or 0.01", text);
    return *value;
}

std::uint64_t read_bytes(std::string_view option, std::string_view text)
{
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    const std::optional<double> bytes = value_with_unit(lower, {{"", 1},
                                                                {"b", 1},
                                                                {"k", 1e3},
                                                                {"kb", 1e3},
                                                                {"m", 1e6},
                                                                {"mb", 1e6},
                                                                {"g", 1e9},
                                                                {"gb", 1e9},
                                                                {"t", 1e12},
                                                                {"tb", 1e12},
                                                                {"kib", 1024.0},
                                                                {"mib", 0x1p20},
                                                                {"gib", 0x1p30},
                                                                {"tib", 0x1p40}});
    if (!bytes || *bytes < 1.0 || *bytes > 0x1p63)
        refuse(option, "a size such as 512MB, 2GB or 1GiB", text);
    return static_cast<std::uint64_t>(*bytes);
}

double read_seconds(std::string_view option, std::string_view text)
{
    const std::optional<double> seconds =
        value_with_unit(text, {{"", 1}, {"s", 1}, {"ms", 1e-3}, {"m", 60}, {"min", 60}, {"h", 3600}});
    if (!seconds || *seconds <= 0.0 || std::isinf(*seconds))
        refuse(option, "a time such as 30s, 5m, 2h or 250ms", text);
    return *seconds;
}

Vec3 read_vec3(std::string_view option, std::string_view text)
{
    std::vector<double> values;
    for (const std::string_view part : split(text, ','))
        if (const std::optional<double> value = number_value(part))
            values.push_back(*value);
        else
            refuse(option, "three numbers such as 1,2.5,-3", text);
    if (values.size() != 3)
        refuse(option, "three numbers such as 1,2.5,-3", text);
    return {values[0], values[1], values[2]};
}

Vec3 read_direction(std::string_view option, std::string_view text)
{
    const Vec3 v = read_vec3(option, text);
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (largest == 0.0)
        refuse(option, "a direction such as 0,1,0", text);
    const int exponent = -std::ilogb(largest);
    return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

PixelSize read_pixel_size(std::string_view option, std::string_view text, int largest)
{
    const std::vector<std::string_view> parts = split(text, 'x');
    const std::optional<std::uint64_t> width = count_value(parts.front());
    const std::optional<std::uint64_t> height = count_value(parts.back());
    if (parts.size() != 2 || !width || !height)
        refuse(option, "a width and height in pixels such as 800x600", text);
    const auto fits = [&](std::uint64_t side) { return side >= 1 && side <= static_cast<std::uint64_t>(largest); };
    if (!fits(*width) || !fits(*height))
        refuse(option, "a width and a height from 1 to " + std::to_string(largest) + " pixels", text);
    return {static_cast<int>(*width), static_cast<int>(*height)};
}

} // namespace multipath
