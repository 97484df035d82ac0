#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

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

} // namespace multipath
