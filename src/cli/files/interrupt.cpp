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

std::atomic<int> signal_received{0};
std::atomic<int> always_ends{0};
static_assert(std::atomic<int>::is_always_lock_free, "signal handlers read them");

/// Writes a text with '?' for control characters, without the heap.
void write_text(const char* text)
{
    for (; *text != '\0'; ++text) {
        const char c = static_cast<unsigned char>(*text) < 0x20 || *text == 0x7f ? '?' : *text;
        write_to_standard_error(&c, 1);
    }
}

extern "C" void end_at_once(int)
{
    if (standard_error_is_terminal()) // its current line may show the progress or ^C
        write_to_standard_error("\n", 1);
    write_text("interrupted");
    settle_unfinished([](const char* target) {
        write_text("; not written: ");
        write_text(target);
    });
    write_to_standard_error("\n", 1);
    end_process(exit_interrupted);
}

extern "C" void note_interrupt(int)
{
    signal_received = 1;
    handle_end_signals(end_at_once);
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
    signal_received = 0;
    if (always_ends == 0)
        handle_end_signals(note_interrupt);
}

bool interrupted()
{
    return signal_received != 0;
}

} // namespace multipath
