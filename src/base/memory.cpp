#include "base/memory.h"

#include <cstdint>

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace multipath {

#ifdef MADV_HUGEPAGE

void ask_for_huge_pages(void* memory, std::size_t bytes)
{
    constexpr std::size_t huge_page = std::size_t{1} << 21;
    constexpr std::size_t page = 4096;
    if (bytes < 2 * huge_page)
        return;
    const std::size_t skipped = (page - reinterpret_cast<std::uintptr_t>(memory) % page) % page;
    madvise(static_cast<char*>(memory) + skipped, (bytes - skipped) / page * page,
            MADV_HUGEPAGE); // may be refused
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
