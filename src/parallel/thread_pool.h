#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace multipath {

/// Worker threads that are kept from one task to the next, because starting them takes as long as some tasks.
class ThreadPool
{
public:
    ThreadPool() = default;
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;
    ~ThreadPool();

    /// Runs `work` on up to `threads` threads at once, the caller among them. `work` must drain a shared queue: workers
    /// that start after the caller has returned from it are turned away. The system may grant fewer threads; the caller
    /// always works. `work` must not throw.
    void run(int threads, const std::function<void()>& work);

private:
    void add_workers(std::size_t count);
    void worker_loop();

    std::vector<std::thread> workers_;
    std::mutex mutex_; ///< guards all below
    std::condition_variable wake_;
    std::condition_variable idle_;
    const std::function<void()>* work_ = nullptr;
    int open_slots_ = 0; ///< workers that may still join the present work
    int working_ = 0;
    bool stopping_ = false;
};

/// Runs `work` as ThreadPool does, on a pool that belongs to the calling thread.
void run_on_threads(int threads, const std::function<void()>& work);

} // namespace multipath
