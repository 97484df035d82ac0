#include "cli/interrupt.h"

#include <csignal>

namespace multipath {

namespace {

volatile std::sig_atomic_t received = 0;

extern "C" void note_interrupt(int)
{
    received = 1;
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

} // namespace

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
