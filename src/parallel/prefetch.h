#pragma once

namespace multipath {

/// Has the memory bring what lies at this address, if the compiler knows how to say so.
inline void prefetch(const void* address)
{
#if defined(__GNUC__)
    __builtin_prefetch(address);
#else
    static_cast<void>(address);
#endif
}

} // namespace multipath
