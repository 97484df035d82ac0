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

/// The text without blanks at either end.
std::string_view trimmed(std::string_view text);

/// Removes the first word from `rest` and returns it; empty if only blanks are left.
std::string_view next_word(std::string_view& rest);

/// The text before the first `#`, for statements whose arguments are numbers.
std::string_view without_comment(std::string_view text);

/// The name in the argument of a statement; it may contain blanks. Here a `#` begins a comment only with a blank (or an
/// end of the text) on both sides, because exporters write names such as "Material #25".
std::string_view name_in(std::string_view rest);

/// Parses a finite decimal number, correctly rounded and independent of the locale; nothing for any other word.
std::optional<double> to_number(std::string_view word);

/// Like to_number(), but throws InputError with the reason if `word` is not such a number. `owner` names the quantity.
double read_number(std::string_view word, const TextLocation& place, std::string_view owner);

/// The keywords that a reader ignores, for a single warning.
class IgnoredKeywords
{
public:
    /// At most `most` keywords are named.
    explicit IgnoredKeywords(std::size_t most) : most_(most) {}

    void note(std::string_view keyword, TextLocation place);

    /// "room.obj:12: problem: `a`, `b`", with the line of the first keyword; nothing if no keyword was noted.
    std::optional<std::string> warning(const std::string& problem) const;

private:
    std::size_t most_;
    std::vector<std::string> names_;
    TextLocation first_;
};

} // namespace multipath
