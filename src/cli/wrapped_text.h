#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace multipath {

/// The words of a text in lines of at most `width` columns, broken at spaces, each with its line feed; a longer word
/// has a line of its own. The first line begins at `column`, which the caller has filled so far; the others with
/// `indent` spaces.
std::string wrapped_text(std::string_view text, std::size_t column, std::size_t indent, std::size_t width);

} // namespace multipath
