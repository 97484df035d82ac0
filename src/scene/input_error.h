#pragma once

#include <stdexcept>
#include <string>

namespace multipath {

/// An error in what the user supplied. The message is one plain line, "file:line: what is wrong, what was expected".
class InputError : public std::runtime_error
{
public:
    explicit InputError(const std::string& message) : std::runtime_error(message) {}
};

/// Options that do not fit a sound file: a usage error that can be detected only after the file was read.
class SettingsError : public InputError
{
public:
    using InputError::InputError;
};

} // namespace multipath
