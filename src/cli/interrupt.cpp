#include "cli/interrupt.h"

#include "cli/unfinished.h"

#include <csignal>
#include <unistd.h>

namespace multipath {

namespace {

volatile std::sig_atomic_t received = 0;

extern "C" void end_at_once(int)
{
    remove_unfinished();
    constexpr char message[] = "interrupted\n";
    const auto told = write(STDERR_FILENO, message, sizeof message - 1);
    (void)told;
    _exit(exit_interrupted);
}

extern "C" void note_interrupt(int)
{
    received = 1;
    std::signal(SIGINT, end_at_once);
    std::signal(SIGTERM, end_at_once);
}

} // namespace

void end_at_interrupts()
{
    for (const int signal : {SIGINT, SIGTERM})
        if (std::signal(signal, end_at_once) == SIG_IGN)
            std::signal(signal, SIG_IGN); // as a shell has its background jobs do
}

void watch_interrupts()
{
    std::signal(SIGINT, note_interrupt);
    std::signal(SIGTERM, note_interrupt);
}

bool interrupted()
{
    return received != 0;
}

void end_if_interrupted(const std::string& left)
{
    if (interrupted())
        throw Interrupted(left.empty() ? "interrupted" : "interrupted; " + left);
}

} // namespace multipath
