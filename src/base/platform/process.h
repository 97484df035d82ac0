#pragma once

#include <cstddef>

// What systems do differently with signals, terminals and standard streams.

namespace multipath {

/// Called in a signal handler (POSIX), where only async-signal-safe functions are allowed, or in a thread of its own
/// (Windows).
using SignalHandler = void (*)(int);

/// Calls the handler at SIGINT (Ctrl-C), SIGTERM and SIGHUP (the terminal was closed), or at Ctrl-C, Ctrl-Break and the
/// end of the console. A signal that is ignored when the program starts (in background jobs of a shell, under nohup)
/// stays ignored. The next call replaces the handler. Async-signal-safe.
void handle_end_signals(SignalHandler handler);

/// Writes to standard error; errors are ignored. Async-signal-safe.
void write_to_standard_error(const char* text, std::size_t size) noexcept;

/// Ends the program without running destructors. Async-signal-safe.
[[noreturn]] void end_process(int exit_code) noexcept;

/// Whether standard error is a terminal. Async-signal-safe.
bool standard_error_is_terminal() noexcept;

/// Opens the null device for standard descriptors that are closed, for the opposite direction, so that no file gets
/// their number and printing to them remains an error. Makes a pipe without a reader, and a file above the size limit,
/// errors of write() instead of signals. On Windows, streams are binary, and the console shows UTF-8 and control
/// sequences.
void prepare_process();

} // namespace multipath
