#pragma once

#include <string_view>

namespace multipath {

/// How a PNG file begins.
constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

/// How the data of a comment's chunk begin, before the text: keyword and, for UTF-8 (iTXt), that nothing is compressed
/// or translated.
constexpr std::string_view plain_comment("Comment\0", 8);
constexpr std::string_view utf8_comment("Comment\0\0\0\0\0", 12);

} // namespace multipath
