#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// What printf would print.
#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
std::string
format(const char* pattern, ...);

/// 4194304 as "4,194,304".
std::string grouped(std::uint64_t count);

/// "a, b, c".
std::string join(const std::vector<std::string>& parts, std::string_view separator = ", ");

/// A word as a POSIX shell reads it back, always on one line: plain, in '...' where it must be, and in $'...' (POSIX
/// 2024) with octal escapes where it holds control characters.
std::string shell_word(std::string_view text);

/// " --name value", such that a shell and a command line take the value for one.
std::string option_text(std::string_view name, std::string_view value);

/// How many bytes at the beginning of a text make one well-formed character of UTF-8 (RFC 3629); 0 if none do.
std::size_t utf8_character_size(std::string_view text);

/// Columns of a screen that a text takes, if each of its characters takes one: bytes without continuation bytes.
std::size_t column_count(std::string_view text);

} // namespace multipath
