#pragma once

#include <cstddef>
#include <string_view>

namespace multipath {

/// How many bytes at the beginning of a text make one well-formed character of UTF-8 (RFC 3629); 0 if none do.
std::size_t utf8_character_size(std::string_view text);

/// Columns of a screen that a text takes, if each of its characters takes one: bytes without continuation bytes.
std::size_t column_count(std::string_view text);

} // namespace multipath
