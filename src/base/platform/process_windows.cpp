#ifdef _WIN32

#include "base/platform/process.h"

#include <atomic>
#include <csignal>
#include <fcntl.h>
#include <initializer_list>
#include <io.h>
#include <windows.h>

namespace multipath {

namespace {

std::atomic<SignalHandler> end_handler{nullptr};

/// The system calls it in a new thread. At the end of the console, the program is ended when it returns.
BOOL WINAPI on_console_event(DWORD event)
{
    if (const SignalHandler handler = end_handler)
        handler(SIGINT);
    if (event == CTRL_CLOSE_EVENT || event == CTRL_LOGOFF_EVENT || event == CTRL_SHUTDOWN_EVENT)
        Sleep(INFINITE); // the system ends the program after five seconds
    return TRUE;
}

} // namespace

void handle_end_signals(SignalHandler handler)
{
    if (end_handler.exchange(handler) == nullptr)
        SetConsoleCtrlHandler(on_console_event, TRUE);
}

void write_to_standard_error(const char* text, std::size_t size) noexcept
{
    _write(2, text, static_cast<unsigned>(size));
}

void end_process(int exit_code) noexcept
{
    TerminateProcess(GetCurrentProcess(), static_cast<UINT>(exit_code));
    for (;;)
        Sleep(INFINITE);
}

bool standard_error_is_terminal() noexcept
{
    DWORD mode = 0;
    return GetConsoleMode(GetStdHandle(STD_ERROR_HANDLE), &mode) != 0; // false for NUL, unlike _isatty()
}

void prepare_process()
{
    for (const int descriptor : {0, 1, 2})
        if (_get_osfhandle(descriptor) >= 0)
            _setmode(descriptor, _O_BINARY);
        else
            (void)_open("NUL", (descriptor == 0 ? _O_WRONLY : _O_RDONLY) | _O_BINARY);
    SetConsoleOutputCP(CP_UTF8);
    for (const DWORD stream : {STD_OUTPUT_HANDLE, STD_ERROR_HANDLE}) {
        const HANDLE handle = GetStdHandle(stream);
        DWORD mode = 0;
        if (GetConsoleMode(handle, &mode) != 0)
            SetConsoleMode(handle, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
    }
}

} // namespace multipath

#endif
