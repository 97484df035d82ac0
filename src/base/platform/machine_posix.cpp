#ifndef _WIN32

#include "base/platform/machine.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <limits>
#include <memory>
#include <sys/mman.h>
#include <unistd.h>
#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif
#ifdef __FreeBSD__
#include <sys/types.h>

#include <sys/sysctl.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace multipath {

double machine_memory()
{
    const long pages = sysconf(_SC_PHYS_PAGES);
    double bytes = pages > 0 ? static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE))
                             : std::numeric_limits<double>::infinity();
    // Linux control groups, versions 2 and 1. The file holds "max" if there is no limit.
    for (const char* limit : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
        std::ifstream file(limit);
        if (double allowed = 0.0; file >> allowed && allowed > 0.0)
            bytes = std::min(bytes, allowed);
    }
    return bytes;
}

std::string program_path()
{
#if defined(__APPLE__)
    char path[4096];
    std::uint32_t size = sizeof path;
    const std::string link = _NSGetExecutablePath(path, &size) == 0 ? path : "";
#elif defined(__FreeBSD__)
    int name[] = {CTL_KERN, KERN_PROC, KERN_PROC_PATHNAME, -1};
    char path[4096];
    std::size_t size = sizeof path;
    const std::string link = sysctl(name, 4, path, &size, nullptr, 0) == 0 ? path : "";
#else
    const std::string link = "/proc/self/exe"; // Linux; others may have it, too
#endif
    const std::unique_ptr<char, void (*)(void*)> resolved(realpath(link.c_str(), nullptr), std::free);
    return resolved ? resolved.get() : "";
}

double thread_seconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

#ifdef MADV_HUGEPAGE

void ask_for_huge_pages(void* memory, std::size_t bytes)
{
    constexpr std::size_t huge_page = std::size_t{1} << 21;
    constexpr std::size_t page = 4096;
    if (bytes < 2 * huge_page)
        return;
    const std::size_t skipped = (page - reinterpret_cast<std::uintptr_t>(memory) % page) % page;
    madvise(static_cast<char*>(memory) + skipped, (bytes - skipped) / page * page, MADV_HUGEPAGE); // may be refused
}

#else

void ask_for_huge_pages(void*, std::size_t) {}

#endif

void keep_freed_memory()
{
#ifdef __GLIBC__
    mallopt(M_TRIM_THRESHOLD, 64 << 20);
    mallopt(M_MMAP_THRESHOLD, 32 << 20); // larger blocks are returned at once; glibc's largest value
#endif
}

} // namespace multipath

#endif
