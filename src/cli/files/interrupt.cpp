// The program ends inside the signal handler, so that neither the current work nor a pipe without a reader can delay
// it. Handlers call only async-signal-safe functions (POSIX) and read only lock-free atomics and the slots of
// output_file.cpp.

#include "cli/files/interrupt.h"

#include "base/errors.h"
#include "base/platform/process.h"
#include "cli/files/output_file.h"

#include <atomic>

namespace multipath {

namespace {

constexpr unsigned seconds_to_end = 2;

std::atomic<int> signal_received{0};
std::atomic<int> always_ends{0};
std::atomic<int> delays{0};
static_assert(std::atomic<int>::is_always_lock_free, "signal handlers read them");

/// Writes a text with '?' for control characters, without the heap.
void write_text(const char* text)
{
    for (; *text != '\0'; ++text) {
        const char c = static_cast<unsigned char>(*text) < 0x20 || *text == 0x7f ? '?' : *text;
        write_to_standard_error(&c, 1);
    }
}

/// Begins the last line of the program. On a terminal it is a new line: the current one may show a progress bar or ^C.
void begin_last_line(const char* text)
{
    if (standard_error_is_terminal())
        write_to_standard_error("\n", 1);
    write_text(text);
}

[[noreturn]] void end_last_line(int exit_code)
{
    write_to_standard_error("\n", 1);
    end_process(exit_code);
}

extern "C" void end_at_once(int)
{
    remove_unfinished();
    begin_last_line("interrupted");
    end_last_line(exit_interrupted);
}

extern "C" void end_with_what_is_complete(int)
{
    begin_last_line("interrupted");
    settle_unfinished([](const char* target) {
        write_text("; not written: ");
        write_text(target);
    });
    end_last_line(exit_interrupted);
}

extern "C" void end_failed(int)
{
    remove_unfinished();
    begin_last_line("multipath: a file cannot be read to its end: it was truncated meanwhile, or its disk fails");
    end_last_line(exit_failed);
}

/// Handler of the alarm, two seconds after the first signal.
extern "C" void end_in_time(int signal)
{
    if (delays > 0)
        start_alarm(1, end_in_time);
    else
        end_with_what_is_complete(signal);
}

extern "C" void note_interrupt(int)
{
    signal_received = 1;
    handle_end_signals(end_with_what_is_complete);
    start_alarm(seconds_to_end, end_in_time);
}

} // namespace

void end_at_interrupts()
{
    handle_end_signals(end_at_once);
}

void always_end_at_interrupts()
{
    always_ends = 1;
}

void watch_interrupts()
{
    if (always_ends != 0 || signal_received != 0)
        return;
    handle_end_signals(note_interrupt);
}

void end_at_failed_mappings()
{
    handle_failed_mapping(end_failed);
}

bool interrupted()
{
    return signal_received != 0;
}

InterruptDelay::InterruptDelay()
{
    ++delays;
}

InterruptDelay::~InterruptDelay()
{
    --delays;
}

} // namespace multipath
