#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// Formats values like printf.
__attribute__((format(printf, 1, 2))) std::string format(const char* pattern, ...);

/// Three numbers with so many significant digits: "(1, 2.5, -3)".
std::string triple(double a, double b, double c, int digits);

/// A number with its digits in groups of three: "4,194,304".
std::string grouped(std::uint64_t count);

/// Joins texts with a separator: "a, b, c".
template <class Texts>
std::string join(const Texts& parts, std::string_view separator = ", ")
{
    std::string text;
    for (const auto& part : parts)
        text.append(&part == &*parts.begin() ? "" : separator).append(part);
    return text;
}

/// The texts of all lists, in order.
std::vector<std::string> concatenated(const std::vector<std::vector<std::string>>& lists);

/// The parts of a text between the separators; one more than there are separators.
std::vector<std::string_view> split(std::string_view text, char separator);

/// The text with the letters A to Z as a to z.
std::string lower_case(std::string_view text);

/// The first of many texts and the number of the others: "a, b and 7 more".
std::string first_of(std::vector<std::string> parts, std::size_t most);

/// "1 surface", "14 surfaces"
std::string counted(std::size_t count, const std::string& noun);

/// The text with '?' for control characters, such as those of file names, which terminals obey. Those of `kept` stay.
std::string without_controls(std::string_view text, std::string_view kept = "");

/// Quotes a word for a POSIX shell. A word of harmless characters stays as it is; others are put in '...', with '?' for
/// control characters, so that the result has no line ends.
std::string shell_word(std::string_view text);

/// The length [bytes] of the UTF-8 character at the beginning of a text (RFC 3629); 0 if the text is empty or does not
/// begin with a complete, valid character.
std::size_t utf8_character_size(std::string_view text);

/// The text as valid UTF-8. Bytes that are not part of a UTF-8 character, such as in names from old files, are taken
/// for Latin-1 characters and converted.
std::string valid_utf8(std::string_view text);

/// The width of a UTF-8 text on the screen [columns], at one column per character.
std::size_t column_count(std::string_view text);

} // namespace multipath
