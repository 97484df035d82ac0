#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace multipath {

// Exit codes of the program.
constexpr int exit_done = 0;
constexpr int exit_failed = 1;
constexpr int exit_usage = 2;
constexpr int exit_interrupted = 130;

// Errors that end in a message to the user: one plain line.

/// What the user can change to avoid a problem with a scene. Only the commands know by which options: remedy_options in
/// commands/options/scene_options.cpp, in the same order.
enum class Remedy { patch_size, two_sided, flip, lamp, sky, sun, reflectance_limit };

/// A remedy that an error or a finding proposes. The commands add it to the message, with its option.
struct Advice
{
    Remedy remedy;
    std::string value = "";  ///< such as "0.9" for a limit; empty: there is none, or it depends on what the user wants
    std::string effect = ""; ///< predicate such as "gives every face a back"; empty if the message says it
};

/// An error in what the user supplied (exit code 1). For an error in a file the message is "file:line: what is wrong,
/// what was expected", without the line if the file as a whole is meant.
struct InputError : std::runtime_error
{
    explicit InputError(const std::string& message, std::vector<Advice> remedies = {})
        : std::runtime_error(message), advice(std::move(remedies))
    {
    }

    std::vector<Advice> advice; ///< not yet in the message
};

/// An error in the options (exit code 2): they do not suit a scene whose file is valid. Unlike an error in the command
/// line itself, it is found only after the file has been read.
struct SettingsError : InputError
{
    using InputError::InputError;
};

/// The command line is wrong (exit code 2). The message is one line without the name of the program. main(), which
/// knows the command, adds the way to its help.
struct UsageError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/// A saved state cannot be read, is damaged or belongs to other work (exit code 1).
struct ArchiveError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/// An error in an image file. The message does not name the file: it is a predicate of which the file is the subject
/// ("ends too early"), or a sentence of its own ("12 bits per pixel are not supported").
struct ImageError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/// A result could not be written (exit code 1). The message is one line, such as "cannot write out/room.png: No space
/// left on device".
struct OutputError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/// The reader of standard output has closed it (EPIPE), as `head` does. The exit code is 1, but no message is printed.
struct ReaderGone : OutputError
{
    using OutputError::OutputError;
};

} // namespace multipath
