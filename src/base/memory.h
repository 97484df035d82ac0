#pragma once

#include "base/platform/machine.h"

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace multipath {

/// Number of steps ahead at which loops over lines prefetch the patches that a later step needs: enough to hide the
/// latency of the memory, and few enough to stay in the nearest cache.
constexpr std::size_t prefetch_distance = 24;

/// Prefetches the cache line of this address.
inline void prefetch(const void* address)
{
    __builtin_prefetch(address);
}

/// Prefetches all cache lines of an object.
template <class Object>
void prefetch_all(const Object& object)
{
    constexpr std::size_t cache_line = 64;
    for (std::size_t byte = 0; byte < sizeof(Object); byte += cache_line)
        prefetch(reinterpret_cast<const char*>(&object) + byte);
}

/// Initial contents of the elements that a constructor or resize(count) adds to a vector with LargeAllocator.
enum class NewElements {
    constructed, ///< value-initialised, as in std::vector
    unset,       ///< undefined: the threads that write the elements are the first to touch the memory
    zero         ///< all bits zero, from calloc; only for vectors that are never resized
};

/// Allocator for large arrays, in huge pages if the system grants them. Throws std::bad_alloc if memory is lacking.
template <class Value, NewElements new_elements>
struct LargeAllocator : std::allocator<Value>
{
    static_assert(new_elements == NewElements::constructed || std::is_trivially_copyable<Value>::value,
                  "elements without a constructor must be plain data");
    template <class Other>
    struct rebind
    {
        using other = LargeAllocator<Other, new_elements>;
    };

    LargeAllocator() = default;
    template <class Other>
    explicit LargeAllocator(const LargeAllocator<Other, new_elements>&)
    {
    }

    Value* allocate(std::size_t count)
    {
        Value* const memory = allocate_small_pages(count);
        ask_for_huge_pages(memory, count * sizeof(Value));
        return memory;
    }
    void deallocate(Value* memory, std::size_t count)
    {
        if constexpr (new_elements == NewElements::zero)
            std::free(memory);
        else
            std::allocator<Value>::deallocate(memory, count);
    }

    template <class Other>
    void construct(Other* memory)
    {
        if constexpr (new_elements == NewElements::constructed)
            ::new (static_cast<void*>(memory)) Other();
        else if constexpr (new_elements == NewElements::unset)
            ::new (static_cast<void*>(memory)) Other;
    }
    template <class Other, class... Arguments>
    void construct(Other* memory, Arguments&&... arguments)
    {
        ::new (static_cast<void*>(memory)) Other(std::forward<Arguments>(arguments)...);
    }

private:
    static Value* allocate_small_pages(std::size_t count)
    {
        if constexpr (new_elements == NewElements::zero) {
            static_assert(alignof(Value) <= alignof(std::max_align_t), "calloc aligns for numbers only");
            void* const memory = std::calloc(count, sizeof(Value));
            if (memory == nullptr)
                throw std::bad_alloc();
            return static_cast<Value*>(memory);
        } else {
            return std::allocator<Value>().allocate(count);
        }
    }
};

// Vectors in huge pages, with new elements as the names say: see NewElements.
template <class Value>
using LargeVector = std::vector<Value, LargeAllocator<Value, NewElements::constructed>>;
template <class Value>
using UnsetVector = std::vector<Value, LargeAllocator<Value, NewElements::unset>>;
template <class Value>
using ZeroedVector = std::vector<Value, LargeAllocator<Value, NewElements::zero>>;

/// Empty std::vector with capacity for `count` elements in huge pages, for callers that need this type.
template <class Value>
std::vector<Value> vector_with_capacity(std::size_t count)
{
    std::vector<Value> room;
    room.reserve(count);
    ask_for_huge_pages(room.data(), count * sizeof(Value));
    return room;
}

/// std::vector of `count` value-initialised elements in huge pages.
template <class Value>
std::vector<Value> large_vector(std::size_t count)
{
    std::vector<Value> elements = vector_with_capacity<Value>(count);
    elements.resize(count);
    return elements;
}

} // namespace multipath
