#pragma once

#include <stdexcept>
#include <string>

namespace multipath {

constexpr int exit_interrupted = 130; ///< of the program

/// Work that the user has ended, and of which there is no result: exit code 130. One plain line that says what is left.
class Interrupted : public std::runtime_error
{
public:
    explicit Interrupted(const std::string& message) : std::runtime_error(message) {}
};

/// From now on Ctrl-C (SIGINT) and SIGTERM ask the work to end in good order; a second one kills.
void watch_interrupts();

/// Has one been received?
bool interrupted();

/// Throws Interrupted if one has, so that whatever is half written goes. `left`: what may be gone on from; may be
/// empty.
void end_if_interrupted(const std::string& left = "");

} // namespace multipath
