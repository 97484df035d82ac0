#pragma once

namespace multipath {

// Exit codes of the program.
constexpr int exit_failed = 1;
constexpr int exit_interrupted = 130;

// The signals below are SIGINT (Ctrl-C), SIGTERM and SIGHUP (the terminal was closed). Signals that the program was
// started to ignore (background jobs of a shell, nohup) stay ignored.

/// From now on a signal ends the program at once: removes incomplete outputs, prints one line on stderr and exits with
/// exit_interrupted.
void end_at_interrupts();

/// Makes end_at_interrupts() permanent: watch_interrupts() has no effect any more, also when called by commands that
/// this one runs. `hint`: a string literal to append to the line; that of the first call counts.
void always_end_at_interrupts(const char* hint = "");

/// From now on a signal sets interrupted(), so that the work can stop and write its partial results. The program ends
/// in any case two seconds later, or at once at a second signal: outputs that are complete by then are renamed to their
/// targets; one line names the others, whose old files stay. No effect after always_end_at_interrupts().
void watch_interrupts();

/// True if a watched signal has been received.
bool interrupted();

/// From now on SIGBUS ends the program at once: removes incomplete outputs, prints one line and exits with exit_failed.
/// The signal is raised when a memory-mapped file is truncated while it is read, or its disk fails.
void end_at_bus_errors();

/// While an object exists, the limit of two seconds is extended: a state gets the time to reach the disk. A second
/// signal still ends the program.
class InterruptDelay
{
public:
    InterruptDelay();
    ~InterruptDelay();
    InterruptDelay(const InterruptDelay&) = delete;
    InterruptDelay& operator=(const InterruptDelay&) = delete;
};

} // namespace multipath
