#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// The text that the user gave, in single quotes and with '?' for control characters, so that a message stays one line.
std::string quoted_argument(std::string_view text);

/// The text "; did you mean CANDIDATE?" with the candidate that `word` most likely misspells or begins; "" if none is
/// close. A misspelt word of n letters may have up to max(1, n / 3) errors. An error is a wrong, missing or surplus
/// letter, or two neighbours swapped. Leading dashes and upper or lower case make no difference.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// The words as a list: "a, b or c".
std::string alternatives(const std::vector<std::string_view>& words);

/// Throws UsageError "OPTION: expected one of A, B, C, got 'WORD'" unless `word` is among the choices.
void require_choice(std::string_view option, std::string_view word, const std::vector<std::string_view>& choices);

} // namespace multipath
