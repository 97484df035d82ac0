#include "cli/options/number_text.h"

#include "base/elementary.h"
#include "base/errors.h"
#include "base/text_format.h"
#include "cli/options/command_line.h"
#include "scene/text/text_words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace multipath {

namespace {

[[noreturn]] void refuse(std::string_view option, const std::string& expected, std::string_view text)
{
    throw UsageError(std::string(option) + ": expected " + expected + ", got " + quoted_argument(text));
}

/// The value of plain digits, at most 2^64 - 1; nothing for any other text.
std::optional<std::uint64_t> digits_value(std::string_view text)
{
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const std::from_chars_result result = std::from_chars(text.data(), end, value);
    return result.ec == std::errc() && result.ptr == end ? std::optional<std::uint64_t>(value) : std::nullopt;
}

/// The value of a decimal number times 10^exponent, correctly rounded; nothing for any other text, and for a value out
/// of the range of normal doubles.
std::optional<double> decimal_value(std::string_view text, int exponent = 0)
{
    if (text.empty() || text[0] == '+')
        return std::nullopt;
    const std::string written = std::string(text) + (exponent != 0 ? "e" + std::to_string(exponent) : "");
    const std::optional<double> value = to_number(written);
    const bool is_zero = text.substr(0, text.find_first_of("eE")).find_first_of("123456789") == std::string_view::npos;
    if (!value || (!std::isnormal(*value) && !is_zero))
        return std::nullopt;
    return is_zero ? 0.0 : *value; // not -0
}

/// The value of `2^20`, `1e6` or `1.5M`. M and G only in upper case: `1m` could mean a thousandth.
std::optional<double> number_value(std::string_view text)
{
    if (const std::size_t caret = text.find('^'); caret != std::string_view::npos) {
        const std::optional<std::uint64_t> base = digits_value(text.substr(0, caret));
        const std::optional<std::uint64_t> exponent = digits_value(text.substr(caret + 1));
        const double value =
            elementary::pow(static_cast<double>(base.value_or(0)), static_cast<double>(exponent.value_or(0)));
        return base && exponent && std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
    }
    const char last = text.empty() ? '\0' : text.back();
    const int thousands = last == 'k' || last == 'K' ? 1 : last == 'M' ? 2 : last == 'G' ? 3 : 0;
    return decimal_value(text.substr(0, text.size() - (thousands > 0 ? 1 : 0)), 3 * thousands);
}

std::optional<std::uint64_t> count_value(std::string_view text)
{
    if (const std::optional<std::uint64_t> exact = digits_value(text))
        return exact;
    const std::optional<double> value = number_value(text);
    if (!value || text[0] == '-' || *value != std::floor(*value) || *value >= 0x1p64)
        return std::nullopt;
    return static_cast<std::uint64_t>(*value);
}

struct Unit
{
    std::string_view name;
    double factor;
};

constexpr std::array<Unit, 7> units_of_memory = {
    {{"", 1.0}, {"m", 1e6}, {"mi", 0x1p20}, {"g", 1e9}, {"gi", 0x1p30}, {"t", 1e12}, {"ti", 0x1p40}}};
constexpr std::array<Unit, 6> units_of_time = {
    {{"", 1.0}, {"s", 1.0}, {"ms", 1e-3}, {"m", 60.0}, {"min", 60.0}, {"h", 3600.0}}};

/// The value of a number that is followed by one of the units; nothing for any other text. Suffixes such as k, M and G
/// count only if they are among the units.
template <class Units>
std::optional<double> value_with_unit(std::string_view text, const Units& units)
{
    const std::size_t number_length = std::min(text.find_last_of("0123456789.") + 1, text.size());
    const std::optional<double> value = number_value(text.substr(0, number_length));
    for (const Unit& unit : units)
        if (value && unit.name == text.substr(number_length))
            return *value * unit.factor;
    return std::nullopt;
}

} // namespace

std::uint64_t read_count(std::string_view option, std::string_view text, std::uint64_t low, std::uint64_t high)
{
    const std::optional<std::uint64_t> value = count_value(text);
    const std::string most = high == largest_count ? "2^63" : std::to_string(high);
    if (!value || *value < low || *value > high)
        refuse(option, "a count from " + std::to_string(low) + " to " + most + " such as 1000000, 1e6, 1M or 2^20",
               text);
    return *value;
}

double read_real(std::string_view option, std::string_view text, double low, double high)
{
    const std::optional<double> value = number_value(text);
    if (!value || *value < low || *value > high)
        refuse(option, format("a number from %g to %g such as 0.5, 1e-3 or 2M", low, high), text);
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
    const std::optional<double> value =
        percent ? decimal_value(text.substr(0, text.size() - 1), -2) : decimal_value(text);
    if (!value || *value < 0.0 || *value > 1.0 || (*value == 1.0 && !percent))
        refuse(option, "a share such as 1% or 0.01", text);
    return *value;
}

std::uint64_t read_bytes(std::string_view option, std::string_view text)
{
    std::string size = lower_case(text);
    if (!size.empty() && size.back() == 'b')
        size.pop_back();
    const std::optional<double> bytes = value_with_unit(size, units_of_memory);
    if (!bytes || *bytes < 1.0 || *bytes > 0x1p63)
        refuse(option, "a size such as 512MB, 2GB or 1GiB", text);
    return static_cast<std::uint64_t>(*bytes);
}

double read_seconds(std::string_view option, std::string_view text)
{
    const std::optional<double> seconds = value_with_unit(text, units_of_time);
    if (!seconds || *seconds <= 0.0 || std::isinf(*seconds))
        refuse(option, "a time such as 30s, 5m, 2h or 250ms", text);
    return *seconds;
}

Vec3 read_vec3(std::string_view option, std::string_view text)
{
    std::vector<double> values;
    for (const std::string_view part : split(text, ','))
        values.push_back(number_value(part).value_or(std::numeric_limits<double>::quiet_NaN()));
    if (values.size() != 3 || std::any_of(values.begin(), values.end(), [](double x) { return std::isnan(x); }))
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
    const auto fits = [&](const std::optional<std::uint64_t>& side) {
        return side && *side >= 1 && *side <= static_cast<std::uint64_t>(largest);
    };
    if (parts.size() != 2 || !fits(width) || !fits(height))
        refuse(option, "a width and height from 1 to " + std::to_string(largest) + " pixels such as 800x600", text);
    return {static_cast<int>(*width), static_cast<int>(*height)};
}

} // namespace multipath
