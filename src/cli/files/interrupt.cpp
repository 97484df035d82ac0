// The program ends inside the signal handler, so that neither the current work nor a pipe without a reader can delay
// it. Handlers call only async-signal-safe functions (POSIX) and read only lock-free atomics and the slots of
// output_file.cpp.

#include "cli/files/interrupt.h"

#include "base/errors.h"
#include "base/platform/process.h"
#include "cli/files/output_file.h"

#include <array>
#include <atomic>
#include <cstddef>

namespace multipath {

namespace {

constexpr unsigned seconds_to_end = 2;

// Flags are int, not bool: RISC-V has no atomic exchange of single bytes.
std::atomic<int> signal_received{0};
std::atomic<int> always_ends{0};
std::atomic<const char*> end_hint{""};
std::atomic<int> delays{0};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<const char*>::is_always_lock_free,
              "signal handlers read them");

/// Composes and writes the last line of the program, without the heap.
class LastLine
{
public:
    /// On a terminal the text begins on a new line: the current one may show a progress bar or ^C.
    void begin(const char* text)
    {
        if (standard_error_is_terminal())
            text_[size_++] = '\n';
        add(text);
    }
    void add(const char* text)
    {
        for (; *text != '\0' && size_ < text_.size() - 1; ++text)
            text_[size_++] = static_cast<unsigned char>(*text) < 0x20 || *text == 0x7f ? '?' : *text;
    }
    void add_output(const char* name)
    {
        add(outputs_++ == 0 ? "; not written: " : ", ");
        add(name);
    }
    [[noreturn]] void end_program(int exit_code)
    {
        text_[size_++] = '\n';
        write_to_standard_error(text_.data(), size_);
        end_process(exit_code);
    }

private:
    std::array<char, 4096> text_{};
    std::size_t size_ = 0;
    int outputs_ = 0;
};

LastLine last_line;

extern "C" void end_at_once(int)
{
    remove_unfinished();
    const char* const hint = end_hint;
    last_line.begin("interrupted");
    last_line.add(*hint != '\0' ? "; " : "");
    last_line.add(hint);
    last_line.end_program(exit_interrupted);
}

extern "C" void end_with_what_is_complete(int)
{
    last_line.begin("interrupted");
    settle_unfinished([](const char* target) { last_line.add_output(target); });
    last_line.end_program(exit_interrupted);
}

extern "C" void end_failed(int)
{
    remove_unfinished();
    last_line.begin("multipath: a file cannot be read to its end: it was truncated meanwhile, or its disk fails");
    last_line.end_program(exit_failed);
}

/// Handler of the alarm, two seconds after the first signal.
extern "C" void end_in_time(int signal)
{
    if (delays > 0)
        start_alarm(1);
    else
        end_with_what_is_complete(signal);
}

extern "C" void note_interrupt(int)
{
    signal_received = 1;
    handle_end_signals(end_with_what_is_complete);
    start_alarm(seconds_to_end);
}

} // namespace

void end_at_interrupts()
{
    handle_end_signals(end_at_once);
}

void always_end_at_interrupts(const char* hint)
{
    if (always_ends.exchange(1) == 0) // the first call is by the command that the user typed
        end_hint = hint;
}

void watch_interrupts()
{
    if (always_ends != 0 || signal_received != 0)
        return;
    handle_alarm(end_in_time);
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
