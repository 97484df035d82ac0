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

/// The file is sound, but what the options ask for does not go with it: wrong usage, found only when it was read.
class SettingsError : public InputError
{
public:
    using InputError::InputError;
};

} // namespace multipath
