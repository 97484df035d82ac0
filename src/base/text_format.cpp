#include "base/text_format.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace multipath {

std::string format(const char* pattern, ...)
{
    va_list values;
    va_start(values, pattern);
    va_list values_again;
    va_copy(values_again, values);
    const int length = std::vsnprintf(nullptr, 0, pattern, values);
    va_end(values);
    std::string text(static_cast<std::size_t>(std::max(length, 0)), '\0');
    std::vsnprintf(text.data(), text.size() + 1, pattern, values_again);
    va_end(values_again);
    return text;
}

std::string triple(double a, double b, double c, int digits)
{
    return format("(%.*g, %.*g, %.*g)", digits, a, digits, b, digits, c);
}

std::string grouped(std::uint64_t count)
{
    std::string digits = std::to_string(count);
    for (std::size_t position = digits.size(); position > 3; position -= 3)
        digits.insert(position - 3, ",");
    return digits;
}

std::vector<std::string> concatenated(const std::vector<std::vector<std::string>>& lists)
{
    std::vector<std::string> all;
    for (const std::vector<std::string>& list : lists)
        all.insert(all.end(), list.begin(), list.end());
    return all;
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

std::string lower_case(std::string_view text)
{
    std::string result(text);
    for (char& c : result)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return result;
}

std::string first_of(std::vector<std::string> parts, std::size_t most)
{
    const std::size_t others = parts.size() - std::min(parts.size(), most);
    parts.resize(parts.size() - others);
    return join(parts) + (others > 0 ? " and " + std::to_string(others) + " more" : "");
}

std::string counted(std::size_t count, const std::string& noun)
{
    return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

namespace {

bool is_continuation(char c)
{
    return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u;
}

} // namespace

std::size_t utf8_character_size(std::string_view text)
{
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    if (text.empty())
        return 0;
    if (byte(0) < 0x80)
        return 1;
    const std::size_t size = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
    if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < size)
        return 0;
    for (std::size_t k = 1; k < size; ++k)
        if (!is_continuation(text[k]))
            return 0;
    // Overlong encodings, surrogates of UTF-16, and values above the last character.
    const bool wrong = (byte(0) == 0xe0 && byte(1) < 0xa0) || (byte(0) == 0xed && byte(1) > 0x9f) ||
                       (byte(0) == 0xf0 && byte(1) < 0x90) || (byte(0) == 0xf4 && byte(1) > 0x8f);
    return wrong ? 0 : size;
}

std::string valid_utf8(std::string_view text)
{
    std::string valid;
    while (!text.empty()) {
        const std::size_t length = utf8_character_size(text);
        if (length == 0) {
            const auto latin = static_cast<unsigned char>(text[0]);
            valid += static_cast<char>(0xc0 | latin >> 6);
            valid += static_cast<char>(0x80 | (latin & 0x3f));
        } else {
            valid += text.substr(0, length);
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return valid;
}

std::size_t column_count(std::string_view text)
{
    return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), is_continuation));
}

namespace {

/// Characters that no shell interprets.
constexpr std::string_view plain_characters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:,^%+=@";

bool is_control(char c)
{
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

} // namespace

std::string without_controls(std::string_view text, std::string_view kept)
{
    std::string result(text);
    for (char& c : result)
        c = is_control(c) && kept.find(c) == std::string_view::npos ? '?' : c;
    return result;
}

std::string shell_word(std::string_view text)
{
    if (!text.empty() && text.find_first_not_of(plain_characters) == std::string_view::npos)
        return std::string(text);
    std::string quoted = "'";
    for (const char c : without_controls(text))
        quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

} // namespace multipath
