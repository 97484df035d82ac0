// The memory of all containers of the program comes from here, so that none of them needs to know.

#include "parallel/huge_pages.h"

#include <cstdint>
#include <cstdlib>
#include <new>

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

// AddressSanitizer watches `new` itself.
#if defined(__SANITIZE_ADDRESS__)
#define MULTIPATH_WATCHED_MEMORY
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define MULTIPATH_WATCHED_MEMORY
#endif
#endif

#ifdef MADV_HUGEPAGE

namespace multipath {

void ask_for_huge_pages(void* memory, std::size_t bytes)
{
    constexpr std::size_t huge_page = std::size_t{1} << 21;
    constexpr std::size_t page = 4096;
    if (bytes < 2 * huge_page)
        return;
    const std::size_t beside = (page - reinterpret_cast<std::uintptr_t>(memory) % page) % page;
    madvise(static_cast<char*>(memory) + beside, (bytes - beside) / page * page, MADV_HUGEPAGE); // only a wish
}

} // namespace multipath

#else

void multipath::ask_for_huge_pages(void*, std::size_t) {}

#endif

#if defined(MADV_HUGEPAGE) && !defined(MULTIPATH_WATCHED_MEMORY)

namespace {

/// What the standard asks of operator new: until it succeeds, or nobody knows how to make room.
template <class Allocate>
void* allocated(std::size_t bytes, const Allocate& allocate)
{
    for (;;) {
        if (void* const memory = allocate()) {
            multipath::ask_for_huge_pages(memory, bytes);
            return memory;
        }
        const std::new_handler make_room = std::get_new_handler();
        if (!make_room)
            throw std::bad_alloc();
        make_room();
    }
}

} // namespace

void* operator new(std::size_t bytes)
{
    return allocated(bytes, [&] { return std::malloc(bytes > 0 ? bytes : 1); });
}

void* operator new(std::size_t bytes, std::align_val_t alignment)
{
    const auto step = static_cast<std::size_t>(alignment);
    return allocated(bytes, [&]() -> void* {
        const std::size_t whole = (bytes + step - 1) / step * step; // as aligned_alloc wants it
        return whole < bytes ? nullptr : std::aligned_alloc(step, whole > 0 ? whole : step);
    });
}

void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept
{
    try {
        return operator new(bytes);
    } catch (...) {
        return nullptr;
    }
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, const std::nothrow_t&) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
    std::free(memory);
}

#endif
