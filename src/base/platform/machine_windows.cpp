#ifdef _WIN32

#include "base/platform/machine.h"

#include <limits>
#include <windows.h>

namespace multipath {

double machine_memory()
{
    MEMORYSTATUSEX status{};
    status.dwLength = sizeof status;
    return GlobalMemoryStatusEx(&status) != 0 ? static_cast<double>(status.ullTotalPhys)
                                              : std::numeric_limits<double>::infinity();
}

std::string program_path()
{
    char path[4096];
    const DWORD length = GetModuleFileNameA(nullptr, path, sizeof path);
    return length < sizeof path ? std::string(path, length) : "";
}

double thread_seconds()
{
    FILETIME begin{};
    FILETIME end{};
    FILETIME in_system{};
    FILETIME in_program{};
    GetThreadTimes(GetCurrentThread(), &begin, &end, &in_system, &in_program);
    const auto seconds = [](FILETIME time) { // units of 100 ns
        return 1e-7 * (4294967296.0 * time.dwHighDateTime + time.dwLowDateTime);
    };
    return seconds(in_system) + seconds(in_program);
}

void ask_for_huge_pages(void*, std::size_t) {}

void keep_freed_memory() {}

} // namespace multipath

#endif
