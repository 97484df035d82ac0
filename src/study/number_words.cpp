#include "study/number_words.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace multipath {

namespace {

std::string printed(const char* pattern, int decimals, double value)
{
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), pattern, decimals, value);
    return text.data();
}

std::string superscript(const std::string& digits)
{
    constexpr std::array<const char*, 10> raised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char c : digits)
        text += c == '-' ? "⁻" : raised[static_cast<std::size_t>(c - '0')];
    return text;
}

} // namespace

std::string fixed(double value, int decimals)
{
    const std::string digits = printed("%.*f", decimals, std::abs(value));
    const bool zero = digits.find_first_not_of("0.") == std::string::npos;
    return (value < 0.0 && !zero ? "−" : "") + digits;
}

std::string scientific(double value)
{
    std::string text = printed("%.*e", 1, value);
    const std::size_t e = text.find('e');
    if (e == std::string::npos)
        return text; // not a number
    return text.substr(0, e) + "·10" + superscript(std::to_string(std::stoi(text.substr(e + 1))));
}

std::string slope_words(const std::optional<PowerLaw>& law)
{
    if (!law)
        return "none";
    return fixed(law->exponent, 3) + " ± " + fixed(exponent_interval(*law), 3);
}

} // namespace multipath
