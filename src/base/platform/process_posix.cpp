#ifndef _WIN32

#include "base/platform/process.h"

#include <csignal>
#include <fcntl.h>
#include <initializer_list>
#include <unistd.h>

namespace multipath {

void handle_end_signals(SignalHandler handler)
{
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigfillset(&action.sa_mask);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before = {};
        if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
            sigaction(signal, &action, nullptr);
    }
}

void write_to_standard_error(const char* text, std::size_t size) noexcept
{
    const auto written = write(STDERR_FILENO, text, size);
    (void)written;
}

void end_process(int exit_code) noexcept
{
    _exit(exit_code);
}

bool standard_error_is_terminal() noexcept
{
#ifdef __EMSCRIPTEN__
    return true; // the worker of the laboratory reads it at once, as a terminal does
#else
    return isatty(STDERR_FILENO) != 0;
#endif
}

void prepare_process()
{
    constexpr int modes[] = {O_WRONLY, O_RDONLY, O_RDONLY};
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(descriptor, F_GETFD) < 0)
            (void)open("/dev/null", modes[descriptor]); // gets the lowest free number: this one
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

} // namespace multipath

#endif
