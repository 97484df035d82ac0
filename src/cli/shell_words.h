#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// A word as a POSIX shell reads it back, always on one line: plain, in '...' where it must be, and in $'...' (POSIX
/// 2024) with octal escapes where it holds control characters.
std::string shell_word(std::string_view text);

/// Words as they would be typed.
std::string shell_text(const std::vector<std::string>& words);

/// The words of a text that shell_word() wrote; nothing for a text that a shell would do more with than split it, such
/// as one with a variable, a pipe or a quote that stays open.
std::optional<std::vector<std::string>> split_shell_words(std::string_view text);

/// The parts of a text between the separators that stand outside quotes.
std::vector<std::string> split_outside_quotes(std::string_view text, std::string_view separator);

} // namespace multipath
