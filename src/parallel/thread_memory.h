#pragma once

#include <memory>

namespace multipath {

/// Keeps an object until the calling thread calls release_thread_memory(), or the program ends. Returns its address.
void* keep_for_this_thread(std::shared_ptr<void> object);

/// Destroys what the calling thread keeps: the last call of a thread.
void release_thread_memory();

/// The T of the calling thread, made when the thread first asks for it. One type for each purpose: two functions that
/// name the same type share the object. It takes the place of a `thread_local T`, which MinGW frees before it calls the
/// destructor (GCC bug 80816).
template <class T>
T& thread_memory()
{
    thread_local T* object = nullptr;
    if (!object)
        object = static_cast<T*>(keep_for_this_thread(std::make_shared<T>()));
    return *object;
}

} // namespace multipath
