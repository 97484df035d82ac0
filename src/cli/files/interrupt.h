#pragma once

namespace multipath {

// The signals below are those of handle_end_signals() (base/platform/process.h): Ctrl-C, and others that end a program.

/// From now on a signal ends the program at once with exit_interrupted: outputs that are complete are renamed to their
/// targets, and one line on stderr names the others, whose old files stay.
void end_at_interrupts();

/// Disables watch_interrupts() for the rest of the program, for commands that run other commands.
void always_end_at_interrupts();

/// From now on the first signal makes interrupted() true, so that the work can stop and write its partial results. A
/// second one ends the program at once. No effect after always_end_at_interrupts().
void watch_interrupts();

/// True if a signal has been received since watch_interrupts().
bool interrupted();

} // namespace multipath
