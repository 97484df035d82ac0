#pragma once

#include "scene/text/text_lines.h"

#include <cstddef>
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

/// The text before the first `#`, for statements whose arguments are numbers. A `#` after a point is part of a number
/// that is not finite, as in the "1.#INF" and "-1.#IND" of old C libraries.
std::string_view without_comment(std::string_view text);

/// The name in the argument of a statement. A name may contain blanks. Since exporters write names such as "Material
/// #25", a `#` begins a comment only if it has a blank, or the beginning or end of the text, on both sides.
std::string_view name_in(std::string_view rest);

/// The names of a file, each as name_in() reads it; but texts that would become the same name, such as "Paint # 2" and
/// "Paint # 3", are names themselves.
std::vector<std::string> without_comments(std::vector<std::string> texts);

/// Parses a finite decimal number, correctly rounded; returns nothing for any other word. The decimal point is always
/// ".".
std::optional<double> to_number(std::string_view word);

/// Like to_number(), but throws InputError with the reason if `word` is not such a number. The message begins with the
/// location `place` and with `owner`, the name of what the number belongs to, for example "vertex".
double read_number(std::string_view word, const TextLocation& place, std::string_view owner);

/// Collects the keywords that a reader ignores, for a single warning.
class IgnoredKeywords
{
public:
    /// The warning names at most `most` different keywords, the first ones of the file.
    explicit IgnoredKeywords(std::size_t most) : most_(most) {}

    /// Records an ignored keyword and its location.
    void note(std::string_view keyword, TextLocation place);

    /// Returns the warning "room.obj:12: problem: `a`, `b`" with the line of the first keyword; nothing if no keyword
    /// was recorded.
    std::optional<std::string> warning(const std::string& problem) const;

private:
    std::size_t most_;
    std::vector<std::string> names_; ///< different keywords in backquotes
    TextLocation first_;             ///< of the first keyword
};

} // namespace multipath
