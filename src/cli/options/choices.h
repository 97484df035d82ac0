#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// The text that the user gave, in single quotes and with '?' for control characters, so that a message stays one line.
std::string quoted_argument(std::string_view text);

/// Throws UsageError "OPTION: expected one of A, B, C, got 'WORD'" unless `word` is among the choices.
void require_choice(std::string_view option, std::string_view word, const std::vector<std::string_view>& choices);

} // namespace multipath
