#pragma once

#include "scene/text/text_lines.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

inline bool is_blank(char c)
{
    return c == ' ' || (c <= '\f' && (c == '\t' || c == '\v' || c == '\f'));
}

/// The text without blanks at its beginning and end.
std::string_view trimmed(std::string_view text);

/// Removes the first word, and blanks before it, from `rest` and returns the word; empty if only blanks are left.
std::string_view next_word(std::string_view& rest);

/// True if two names differ at most in the case of their letters (ASCII).
bool equal_but_for_case(std::string_view a, std::string_view b);

/// True if a file name ends in `ending`, in upper or lower case.
bool ends_in(std::string_view name, std::string_view ending);

/// The text before the first `#`, for statements whose arguments are numbers. A `#` after a point is part of a number
/// that is not finite, as in the "1.#INF" and "-1.#IND" of old C libraries.
std::string_view without_comment(std::string_view text);

/// The name in the argument of a statement. A name may contain blanks. Since exporters write names such as "Material
/// #25", a `#` begins a comment only if it has a blank, or the beginning or end of the text, on both sides.
std::string_view name_in(std::string_view rest);

/// Parses a finite decimal number, correctly rounded; returns nothing for any other word. The decimal point is always
/// ".".
std::optional<double> to_number(std::string_view word);

/// Like to_number(), but throws InputError with the reason if `word` is not such a number. The message begins with the
/// location `place` and with `owner`, the name of what the number belongs to, for example "vertex".
double read_number(std::string_view word, const TextLocation& place, std::string_view owner);

/// Collects what is wrong in the lines of a file, for one warning about each kind of flaw.
class Flaws
{
public:
    /// Counts a flaw. `word`: the word that it concerns, such as an ignored keyword, or empty.
    void add(std::string_view flaw, std::uint32_t line, std::string_view word = "");

    /// "room.obj:12: flaw (3 in the file)" with the first line, or "room.obj:12: flaw: `a`, `b`" with the first 16
    /// different words.
    std::vector<std::string> warnings(const std::string& path) const;

private:
    struct Flaw
    {
        std::string text;
        std::uint32_t first_line;
        std::size_t count = 0;
        std::vector<std::string> words = {}; ///< different ones in backquotes
    };
    std::vector<Flaw> flaws_;
};

} // namespace multipath
