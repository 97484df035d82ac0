// Decimal numbers are parsed by hand. Most numbers in a mesh have so few digits that the digits and the power of ten
// are both exact as doubles, and one multiplication or division gives the correctly rounded result (Clinger 1990). The
// few others go to strtod.

#include "scene/text/text_words.h"

#include "base/lists.h"
#include "base/text_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace multipath {

namespace {

constexpr std::array<double, 23> exact_powers_of_ten = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                        1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                        1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

// Not std::optional, because copying one costs as much as parsing a number.
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Appends the digits at p to the number and returns their end. More than 19 digits overflow.
const char* scan_digits(const char* p, const char* end, std::uint64_t& number)
{
    for (; p != end && *p >= '0' && *p <= '9'; ++p)
        number = 10 * number + static_cast<std::uint64_t>(*p - '0');
    return p;
}

const char* scan_sign(const char* p, const char* end, bool& negative)
{
    if (p != end && (*p == '+' || *p == '-'))
        negative = *p++ == '-';
    return p;
}

/// The value of a finite decimal number; no_number for any other word.
double value_of(std::string_view word)
{
    const char* const end = word.data() + word.size();
    bool negative = false;
    std::uint64_t digits = 0; // value = digits * 10^exponent
    std::int64_t exponent = 0;
    const char* const whole = scan_sign(word.data(), end, negative);
    const char* p = scan_digits(whole, end, digits);
    std::ptrdiff_t digit_count = p - whole;
    if (p != end && *p == '.') {
        const char* const fraction = p + 1;
        p = scan_digits(fraction, end, digits);
        digit_count += p - fraction;
        exponent = fraction - p;
    }
    bool is_exact = digit_count <= 19 && digits <= std::uint64_t{1} << 53;
    if (p != end && (*p == 'e' || *p == 'E')) {
        bool divides = false;
        std::uint64_t power = 0;
        const char* const first = scan_sign(p + 1, end, divides);
        p = scan_digits(first, end, power);
        if (p == first)
            return no_number;
        is_exact = is_exact && p - first <= 8;
        const auto size = static_cast<std::int64_t>(is_exact ? power : 0);
        exponent += divides ? -size : size;
    }
    if (digit_count == 0 || p != end)
        return no_number;
    constexpr auto powers = static_cast<std::int64_t>(exact_powers_of_ten.size());
    if (is_exact && exponent > -powers && exponent < powers) {
        const double factor = exact_powers_of_ten[static_cast<std::size_t>(std::abs(exponent))];
        const double value = exponent < 0 ? static_cast<double>(digits) / factor : static_cast<double>(digits) * factor;
        return negative ? -value : value;
    }
    const double value = std::strtod(std::string(word).c_str(), nullptr);
    return std::isfinite(value) ? value : no_number;
}

} // namespace

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && is_blank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back()))
        text.remove_suffix(1);
    return text;
}

std::string_view next_word(std::string_view& rest)
{
    std::size_t begin = 0;
    while (begin < rest.size() && is_blank(rest[begin]))
        ++begin;
    std::size_t end = begin;
    while (end < rest.size() && !is_blank(rest[end]))
        ++end;
    const std::string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(end);
    return word;
}

bool equal_but_for_case(std::string_view a, std::string_view b)
{
    return lower_case(a) == lower_case(b);
}

bool ends_in(std::string_view name, std::string_view ending)
{
    return name.size() >= ending.size() && equal_but_for_case(name.substr(name.size() - ending.size()), ending);
}

std::string_view without_comment(std::string_view text)
{
    std::size_t i = text.find('#');
    while (i != std::string_view::npos && i > 0 && text[i - 1] == '.')
        i = text.find('#', i + 1);
    return text.substr(0, i);
}

std::string_view name_in(std::string_view rest)
{
    for (std::size_t i = rest.find('#'); i != std::string_view::npos; i = rest.find('#', i + 1)) {
        const bool blank_before = i == 0 || is_blank(rest[i - 1]);
        const bool blank_after = i + 1 == rest.size() || is_blank(rest[i + 1]);
        if (blank_before && blank_after)
            return trimmed(rest.substr(0, i));
    }
    return trimmed(rest);
}

std::optional<double> to_number(std::string_view word)
{
    const double value = value_of(word);
    return std::isnan(value) ? std::nullopt : std::optional<double>(value);
}

double read_number(std::string_view word, const TextLocation& place, std::string_view owner)
{
    const double value = value_of(word);
    if (word.empty())
        refuse(place, std::string(owner) + ": a number is missing");
    if (std::isnan(value))
        refuse(place, std::string(owner) + ": " + in_quotes(word) + " is not a finite number" +
                          (word.find(',') != std::string_view::npos ? ", expected a decimal point" : ""));
    return value;
}

void Flaws::add(std::string_view flaw, std::uint32_t line, std::string_view word)
{
    constexpr std::size_t most_words = 16;
    const auto known = std::find_if(flaws_.begin(), flaws_.end(), [&](const Flaw& f) { return f.text == flaw; });
    Flaw& same = known != flaws_.end() ? *known : flaws_.emplace_back(Flaw{std::string(flaw), line});
    ++same.count;
    if (word.empty() || same.words.size() == most_words)
        return;
    const std::string quoted = in_quotes(word);
    if (!is_among(quoted, same.words))
        same.words.push_back(quoted);
}

std::vector<std::string> Flaws::warnings(const std::string& path) const
{
    return mapped(flaws_, [&](const Flaw& flaw) {
        return name_of({path, flaw.first_line}) + ": " + flaw.text +
               (flaw.words.empty() ? " (" + std::to_string(flaw.count) + " in the file)" : ": " + join(flaw.words));
    });
}

} // namespace multipath
