#pragma once

namespace multipath {

// The signals below are those of handle_end_signals() (base/platform/process.h): Ctrl-C, and others that end a program.

/// From now on a signal ends the program at once: it removes all temporary output files, prints one line on stderr and
/// exits with exit_interrupted.
void end_at_interrupts();

/// Disables watch_interrupts() for the rest of the program, for commands that run other commands.
void always_end_at_interrupts();

/// From now on a signal makes interrupted() true, so that the work can stop and write its partial results. If the
/// program still runs two seconds later (see InterruptDelay), or receives a second signal, the handler ends it with
/// exit_interrupted: outputs that are complete are renamed to their targets, and one line on stderr names the others,
/// whose old files stay. No effect after always_end_at_interrupts() or a received signal.
void watch_interrupts();

/// True if a signal has been received since watch_interrupts().
bool interrupted();

/// From now on the program ends at once when a mapped file cannot be read (handle_failed_mapping): it removes all
/// temporary output files, prints one line on stderr and exits with exit_failed.
void end_at_failed_mappings();

/// While an object exists, the program does not end two seconds after a signal (watch_interrupts()): the handler waits
/// and checks again every second, so that a state has the time to reach the disk. A second signal still ends the
/// program at once.
class InterruptDelay
{
public:
    InterruptDelay();
    ~InterruptDelay();
    InterruptDelay(const InterruptDelay&) = delete;
    InterruptDelay& operator=(const InterruptDelay&) = delete;
};

} // namespace multipath
