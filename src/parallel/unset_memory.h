#pragma once

#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace multipath {

/// Memory that is not touched when a vector grows by resize(): its new elements hold anything. For large tables all of
/// whose elements are written afterwards, so that the threads that write them also have the system hand out the memory.
template <class Value>
struct UnsetMemory : std::allocator<Value>
{
    static_assert(std::is_trivially_default_constructible<Value>::value, "nothing may need a constructor");
    template <class Other>
    struct rebind
    {
        using other = UnsetMemory<Other>;
    };

    UnsetMemory() = default;
    template <class Other>
    explicit UnsetMemory(const UnsetMemory<Other>&)
    {
    }

    template <class Other>
    void construct(Other* place)
    {
        ::new (static_cast<void*>(place)) Other;
    }
    template <class Other, class... Arguments>
    void construct(Other* place, Arguments&&... arguments)
    {
        ::new (static_cast<void*>(place)) Other(std::forward<Arguments>(arguments)...);
    }
};

template <class Value>
using UnsetVector = std::vector<Value, UnsetMemory<Value>>;

} // namespace multipath
