#include "parallel/thread_memory.h"

#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace multipath {

namespace {

struct KeptObjects
{
    std::mutex mutex;
    std::map<std::thread::id, std::vector<std::shared_ptr<void>>> of_thread;
};

/// Never destroyed: threads may end after the objects of this file.
KeptObjects& kept_objects()
{
    static KeptObjects& kept = *new KeptObjects;
    return kept;
}

} // namespace

void* keep_for_this_thread(std::shared_ptr<void> object)
{
    KeptObjects& kept = kept_objects();
    const std::lock_guard<std::mutex> lock(kept.mutex);
    return kept.of_thread[std::this_thread::get_id()].emplace_back(std::move(object)).get();
}

void release_thread_memory()
{
    KeptObjects& kept = kept_objects();
    std::unique_lock<std::mutex> lock(kept.mutex);
    const auto objects = kept.of_thread.extract(std::this_thread::get_id());
    lock.unlock(); // the objects are destroyed without it
}

} // namespace multipath
