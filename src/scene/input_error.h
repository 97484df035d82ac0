#pragma once

#include <stdexcept>
#include <string>

namespace multipath {

/// An error in what the user supplied. The message is one plain line. For an error in a file it is "file:line: what is
/// wrong, what was expected", without the line if the file as a whole is meant.
class InputError : public std::runtime_error
{
public:
    explicit InputError(const std::string& message) : std::runtime_error(message) {}
};

/// An error in the options: they do not suit a scene whose file is valid. Unlike an error in the command line itself,
/// it is found only after the file has been read.
class SettingsError : public InputError
{
public:
    using InputError::InputError;
};

} // namespace multipath
