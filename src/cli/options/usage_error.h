#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// The command line is wrong: exit code 2. The message is one plain line without the name of the program; whoever
/// prints it adds help_hint(), since only main knows the command.
class UsageError : public std::runtime_error
{
public:
    explicit UsageError(const std::string& message) : std::runtime_error(message) {}
};

/// The user's text in single quotes, control characters as '?', so that a message stays one line.
std::string quoted_argument(std::string_view text);

/// The candidate that `word` is most likely a misspelling of (a few letters swapped, missing or too many, or an
/// unfinished word), as "; did you mean CANDIDATE?" ready to be appended; "" when none is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// "a, b, c"; with " or " before the last word "a, b or c".
std::string listed(const std::vector<std::string_view>& words, std::string_view before_last = ", ");

/// Throws UsageError "OPTION: expected one of A, B, C, got 'WORD'; did you mean A?" unless `word` is among the choices.
void require_choice(std::string_view option, std::string_view word, const std::vector<std::string_view>& choices);

} // namespace multipath
