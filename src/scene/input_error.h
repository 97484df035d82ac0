#pragma once

#include <stdexcept>
#include <string>

namespace multipath {

/// Something the user gave us is wrong. The message is one plain line, "file:line: what is wrong, what was expected".
class InputError : public std::runtime_error
{
public:
    explicit InputError(const std::string& message) : std::runtime_error(message) {}
};

} // namespace multipath
