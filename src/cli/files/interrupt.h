#pragma once

namespace multipath {

// Exit codes of the program.
constexpr int exit_failed = 1;
constexpr int exit_interrupted = 130;

// Ctrl-C (SIGINT), SIGTERM and SIGHUP (the terminal is closed) are meant below, unless the program was started to
// ignore them, as a shell starts background jobs and nohup its command: those it goes on ignoring.

/// From now on a signal ends the program at once with this exit code and one line, and removes what is half written.
void end_at_interrupts();

/// The same for good: commands that this one runs do not get to write results as of then. `hint`: what the line adds;
/// a string literal.
void always_end_at_interrupts(const char* hint = "");

/// From now on a signal asks the work to end in good order and to write its results as of then. The program ends in any
/// case two seconds later, or at once at a second signal: outputs that are complete by then get their names, one line
/// names the others, whose old files stay. No effect after always_end_at_interrupts().
void watch_interrupts();

/// True if a watched signal has been received.
bool interrupted();

/// From now on the program ends in the same way, but as work that failed, when bytes of a mapped file are gone
/// (SIGBUS): whoever makes a state shorter in place while it is read gives no other sign.
void end_at_lost_bytes();

/// While one lives, the two seconds do not end: the time for a state to reach the disk.
class InterruptDelay
{
public:
    InterruptDelay();
    ~InterruptDelay();
    InterruptDelay(const InterruptDelay&) = delete;
    InterruptDelay& operator=(const InterruptDelay&) = delete;
};

} // namespace multipath
