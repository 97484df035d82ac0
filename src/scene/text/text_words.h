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

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

/// Takes the first word off `rest`; empty when only blanks are left.
std::string_view next_word(std::string_view& rest);

/// Cuts the line at `#`: for statements whose arguments are numbers.
std::string_view without_comment(std::string_view text);

/// The argument of a statement that takes a name: blanks inside belong to it. Here a comment needs a blank on both
/// sides of its `#`, because exporters write names like "Material #25".
std::string_view name_in(std::string_view rest);

/// A finite decimal number, correctly rounded, whatever the locale of the user; nothing else is a number.
std::optional<double> to_number(std::string_view word);

/// The same, but throws InputError that says what `word` is instead; `owner` says whose number it is.
double read_number(std::string_view word, const TextPlace& place, std::string_view owner);

/// Keywords that a reader ignores, told in one warning.
class IgnoredKeywords
{
public:
    /// `most`: so many are named.
    explicit IgnoredKeywords(std::size_t most) : most_(most) {}

    void note(std::string_view keyword, TextPlace place);

    /// "room.obj:12: problem: `a`, `b`", with the place of the first; none if nothing was noted.
    std::optional<std::string> warning(const std::string& problem) const;

private:
    std::size_t most_;
    std::vector<std::string> names_;
    TextPlace first_;
};

} // namespace multipath
