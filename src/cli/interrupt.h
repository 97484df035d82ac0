#pragma once

#include <stdexcept>
#include <string>

namespace multipath {

constexpr int exit_interrupted = 130; ///< exit code of the program

/// Work that the user has ended, and of which there is no result: exit code 130. One plain line that says what is left.
class Interrupted : public std::runtime_error
{
public:
    explicit Interrupted(const std::string& message) : std::runtime_error(message) {}
};

/// From now on Ctrl-C (SIGINT) and SIGTERM end the program at once with this exit code and nothing left half written,
/// but for a signal that the program was started to ignore.
void end_at_interrupts();

/// From now on they ask the work to end in good order; a second one ends it at once.
void watch_interrupts();

/// Has one been received?
bool interrupted();

/// Throws Interrupted if one has, so that whatever is half written goes. `left`: what may be gone on from; may be
/// empty.
void end_if_interrupted(const std::string& left = "");

} // namespace multipath
